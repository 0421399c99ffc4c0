#include "core/safety/driven.h"

#include <algorithm>
#include <cmath>

#include "core/safety/stages.h"

namespace underact::safety {
namespace {

constexpr double kRoundingOfWrench = 1e-12;  // of one that is rendered whole

/// The torque of a driven joint, N m (the force, N, where it slides).
double torqueAt(const Driven& driven, std::size_t joint, const Wrench& wrench) noexcept UNDERACT_REAL_TIME {
  const double of_force = driven.J_v[joint].dot(wrench.f_T_W);
  return driven.turns ? of_force + driven.J_w[joint].dot(wrench.m_T_W) : of_force;
}

double continuousOf(const Thermal& thermal, std::size_t joint) noexcept UNDERACT_REAL_TIME {
  return joint < 3 ? thermal.continuous_N_m[static_cast<Eigen::Index>(joint)] : thermal.more_continuous_N_m[joint - 3];
}

}  // namespace

Wrench limitMotors(const Driven& driven, const Wrench& wrench) noexcept {
  if (!driven.turns) {
    Motion motion;
    motion.renders = driven.renders;
    return {limitMotors(motion, wrench.f_T_W), Vec3::Zero()};
  }
  Vec6 scaled;
  scaled << kMomentArm_m * wrench.f_T_W, wrench.m_T_W;
  const Vec6 rendered = driven.renders_wrench * scaled;
  const Vec3 f_T_W = rendered.head<3>() / kMomentArm_m, m_T_W = rendered.tail<3>();
  if (!isFinite(f_T_W) || !isFinite(m_T_W)) return {};
  const double cut2 = (scaled - rendered).squaredNorm(), size2 = scaled.squaredNorm();
  if (cut2 <= kRoundingOfWrench * kRoundingOfWrench * size2) return wrench;
  return rendered.squaredNorm() <= size2 ? Wrench{f_T_W, m_T_W} : Wrench{};
}

double edgeShare(const Limits& limits, const Driven& driven, const Wrench& wrench) noexcept {
  double keep = 1.0;
  for (std::size_t joint = 0; limits.edge_rad > 0.0 && joint < driven.count; ++joint) {
    const double torque = torqueAt(driven, joint, wrench);
    const double room_rad = torque > 0.0   ? driven.room_above_rad[joint]
                            : torque < 0.0 ? driven.room_below_rad[joint]
                                           : kInfinity;
    keep = std::min(keep, std::clamp(room_rad / limits.edge_rad, 0.0, 1.0));
  }
  return keep;
}

double torqueShare(const Limits& limits, const Heat& heat, const Driven& driven, const Wrench& wrench) noexcept {
  double keep = 1.0;
  for (std::size_t joint = 0; joint < driven.count; ++joint) {
    const double size = std::abs(torqueAt(driven, joint, wrench));
    if (!(size > 0.0)) continue;
    keep = std::min(keep, limits.max_torque_N_m[joint] / size);
    const double bears = continuousOf(limits.thermal, joint);
    if (!(bears > 0.0) || !(heat[joint] > kWarm)) continue;
    const double times = 1.0 + std::max(0.0, 1.0 - heat[joint]) / (heat[joint] - kWarm);
    keep = std::min(keep, times * bears / size);
  }
  return keep;
}

Heat heated(const Limits& limits, const Heat& heat, const Driven& driven, const Wrench& wrench, double dt_s) noexcept {
  const Thermal& thermal = limits.thermal;
  if (!(dt_s > 0.0) || !(thermal.time_constant_s > 0.0)) return heat;
  const double share = std::min(1.0, dt_s / thermal.time_constant_s);
  Heat next = heat;
  for (std::size_t joint = 0; joint < driven.count; ++joint) {
    const double bears = continuousOf(thermal, joint);
    if (!(bears > 0.0)) continue;
    const double load = torqueAt(driven, joint, wrench) / bears;
    const double warmer = heat[joint] + share * (load * load - heat[joint]);
    if (std::isfinite(warmer)) next[joint] = warmer;
  }
  return next;
}

}  // namespace underact::safety
