#include "core/target/friction.h"

#include <algorithm>

namespace underact::target {
namespace {

constexpr double kDefaultPeriod_s = 1e-3;
constexpr double kMicrosecondsPerSecond = 1e6;

/// The share with which a target that slides lags now: from the static to the dynamic one, without a step.
double slidingShare(const Friction& friction, const Grip& grip) noexcept UNDERACT_REAL_TIME {
  const double still = grip.relaxation_left_us / (kMicrosecondsPerSecond * kRelaxation_s);
  return friction.dynamic_share + still * (friction.static_share - friction.dynamic_share);
}

/// One tick of sliding by moved_m. It ends where the target is slow, once the share is the dynamic one.
void slideOn(double moved_m, double dt_s, Grip& grip) noexcept UNDERACT_REAL_TIME {
  const double part = std::min(dt_s / kSpeedOver_s, 1.0);
  const double speed_m_per_s = grip.speed_m_per_s + part * (moved_m / dt_s - grip.speed_m_per_s);
  grip.speed_m_per_s = std::min(static_cast<float>(speed_m_per_s), kFastest_m_per_s);
  if (grip.relaxation_left_us == 0 && grip.speed_m_per_s < kStickSpeed_m_per_s) grip.hold = Hold::Sticks;
  const double left_us = grip.relaxation_left_us - kMicrosecondsPerSecond * dt_s;
  grip.relaxation_left_us = static_cast<std::uint16_t>(std::max(left_us, 0.0));
}

}  // namespace

bool slides(const Friction& friction, const Vec3& p_WT, const Vec3& p_WP, double dt_s, Grip& grip) noexcept {
  if (grip.hold == Hold::None) {
    grip = {Hold::Sticks, 0, 0, 0.0F, p_WP};
    return false;
  }
  const Vec3 along_W = grip.p_WG - p_WP;
  const double travel_m = along_W.norm(), depth_m = (p_WP - p_WT).norm();
  if (grip.hold == Hold::Sticks) {
    if (travel_m <= friction.static_share * depth_m) return false;
    grip.hold = Hold::Slides;
    grip.relaxation_left_us = static_cast<std::uint16_t>(kMicrosecondsPerSecond * kRelaxation_s);
    grip.speed_m_per_s = 0.0F;
  }
  const double lag_m = slidingShare(friction, grip) * depth_m;
  slideOn(std::max(travel_m - lag_m, 0.0), dt_s > 0.0 ? dt_s : kDefaultPeriod_s, grip);
  if (travel_m <= lag_m) return false;
  grip.p_WG = p_WP + (lag_m / travel_m) * along_W;
  return true;
}

}  // namespace underact::target
