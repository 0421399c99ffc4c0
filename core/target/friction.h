#pragma once
#include "core/base/real_time.h"
#include "core/base/types.h"
#include "core/base/valid_bytes.h"

namespace underact::target {

/// Coulomb friction by its coefficients, tangential over normal force: up to the static one the target stays, beyond it
/// the target slides and drags with the dynamic one. Both 0: none. 0 <= dynamic_share <= static_share.
struct Friction {
  double static_share = 0.0, dynamic_share = 0.0;
  /// Whether there is friction at all.
  bool isThere() const noexcept UNDERACT_REAL_TIME { return static_share > 0.0; }
};

/// The point to which static friction holds the target.
struct Grip {
  bool holds = false;
  Vec3 p_WG = Vec3::Zero();
};

/// For bytes from a file: whether the state can be used.
inline bool isValid(const Grip& grip) noexcept {
  return isFlag(grip.holds);
}

/// Whether the grip slides in this tick; then it is moved to where the dynamic share allows it, which is off a curved
/// surface, so the caller puts it back onto it. p_WT: the tip; p_WP: the target without friction. The share is that of
/// the displacement along the surface over the penetration, which is that of the forces where the gains are equal.
/// Within 16 ulp of p_WP and the displacement. Source: Salisbury et al. 1995, Haptic rendering: programming touch
/// interaction; cone of Harwin and Melder 2002.
bool slides(const Friction& friction, const Vec3& p_WT, const Vec3& p_WP, Grip& grip) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::target
