#pragma once
#include "core/base/real_time.h"
#include "core/base/sound.h"
#include "core/base/types.h"

namespace underact::target {

/// Coulomb's, as shares of the force across the surface: up to the static one the target stays where it is, past it the
/// target slides and drags by the dynamic one. Both 0: none. 0 <= dynamic_share <= static_share.
struct Friction {
  double static_share = 0.0, dynamic_share = 0.0;
  /// Whether there is friction at all.
  bool isThere() const noexcept UNDERACT_REAL_TIME { return static_share > 0.0; }
};

/// Where the target holds on.
struct Grip {
  bool holds = false;
  Vec3 p_WG = Vec3::Zero();
};

/// Of bytes from a file.
inline bool isSound(const Grip& grip) noexcept {
  return isFlag(grip.holds);
}

/// Whether the grip slides in this tick; it is moved then, to where the dynamic share lets it be: beside the surface by
/// its bend, so the caller puts it back onto it. p_WT: the tip; p_WP: the target without friction. The share is that of
/// the ways along and across, which is that of the forces where the gains are equal.
/// Within 16 ulp of p_WP and the way. Source: Salisbury et al. 1995, Haptic rendering: programming touch interaction;
/// cone of Harwin and Melder 2002.
bool slides(const Friction& friction, const Vec3& p_WT, const Vec3& p_WP, Grip& grip) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::target
