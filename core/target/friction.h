#pragma once
#include <cstdint>

#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::target {

/// Coulomb friction by its coefficients, tangential over normal force: the target sticks up to the static one, and then
/// slides and drags with the dynamic one until it is slow. Both 0: none. 0 <= dynamic_share <= static_share.
struct Friction {
  double static_share = 0.0, dynamic_share = 0.0;
  /// Whether there is friction at all.
  bool isThere() const noexcept UNDERACT_REAL_TIME { return static_share > 0.0; }
};

/// Below this mean speed of the target along the surface, m/s, sliding ends.
inline constexpr double kStickSpeed_m_per_s = 1e-3;
/// Over which the speed is averaged, s: encoders move a slow tip in steps, with rests of some 20 ms between them.
inline constexpr double kSpeedOver_s = 0.05;
/// Above it the mean speed is not told apart, m/s.
inline constexpr float kFastest_m_per_s = 1e6F;
/// How long after a slip the share takes to go from the static to the dynamic one, s.
inline constexpr double kRelaxation_s = 0.02;

/// What friction does with the target. The numbers are those in files of the state.
enum class Hold : std::uint8_t { None = 0, Sticks = 1, Slides = 2 };

/// The point at which friction holds the target, and how.
struct Grip {
  Hold hold = Hold::None;
  std::uint8_t unused = 0;
  std::uint16_t relaxation_left_us = 0;  // while it slides: until the share is the dynamic one
  float speed_m_per_s = 0.0F;            // while it slides: the mean
  Vec3 p_WG = Vec3::Zero();
};

/// For bytes from a file: whether the state can be used.
inline bool isValid(const Grip& grip) noexcept {
  return grip.hold <= Hold::Sticks || (grip.hold == Hold::Slides && grip.relaxation_left_us <= 1e6 * kRelaxation_s &&
                                       grip.speed_m_per_s >= 0.0F && grip.speed_m_per_s <= kFastest_m_per_s);
}

/// Whether the grip slides in this tick; then it is moved to where the share allows it, which is off a curved surface,
/// so the caller puts it back onto it. p_WT: the tip; p_WP: the target without friction; dt_s: since the last tick, 0:
/// unknown. The share is that of the displacement along the surface over the penetration, which is that of the forces
/// where the gains are equal. Within 16 ulp of p_WP and the displacement. Source: Salisbury et al. 1995, Haptic
/// rendering: programming touch interaction; two cones: Harwin and Melder 2002; the speed below which it sticks:
/// Karnopp 1985.
bool slides(const Friction& friction, const Vec3& p_WT, const Vec3& p_WP, double dt_s,
            Grip& grip) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::target
