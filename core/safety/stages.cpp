#include "core/safety/stages.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/norms.h"

namespace underact::safety {
namespace {

constexpr double kVelocityFilter_s = 5e-3;
constexpr double kRounding = 1e-12;  // of a force that is rendered whole

}  // namespace

bool isFinite(const Vec3& v) noexcept {
  return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}

double sizeOf(const Vec3& f_T_W) noexcept {
  const double largest = largestOf(f_T_W);
  if (!(largest > 0.0)) return 0.0;
  return std::min(largest * (f_T_W / largest).norm(), std::numeric_limits<double>::max());
}

Vec3 followVelocity(const Vec3& last_W, const Vec3& v_WT, double dt_s) noexcept {
  if (!(dt_s > 0.0)) return last_W;
  const Vec3 next_W = last_W + (dt_s / (dt_s + kVelocityFilter_s)) * (v_WT - last_W);
  return isFinite(next_W) ? next_W : Vec3::Zero();
}

double speedShare(const Limits& limits, const Vec3& v_WT) noexcept {
  if (!(v_WT.squaredNorm() > limits.calm_speed_m_per_s * limits.calm_speed_m_per_s)) return 1.0;
  const double width = limits.max_speed_m_per_s - limits.calm_speed_m_per_s;
  return width > 0.0 ? std::clamp((limits.max_speed_m_per_s - sizeOf(v_WT)) / width, 0.0, 1.0) : 0.0;
}

Vec3 limitSpeed(const Limits& limits, const Vec3& v_WT, const Vec3& f_T_W) noexcept {
  if (!(v_WT.squaredNorm() > limits.calm_speed_m_per_s * limits.calm_speed_m_per_s)) return f_T_W;
  const double speed = sizeOf(v_WT);
  const Vec3 along_W = v_WT / speed;
  const double drive_N = f_T_W.dot(along_W);
  if (!(drive_N > 0.0)) return f_T_W;
  const double keep = speedShare(limits, v_WT);
  return f_T_W - ((1.0 - keep) * drive_N) * along_W;
}

Vec3 limitMotors(const Motion& motion, const Vec3& f_T_W) noexcept {
  const Vec3 rendered_T_W = motion.renders * f_T_W;
  if (!isFinite(rendered_T_W)) return Vec3::Zero();
  const double cut2 = (f_T_W - rendered_T_W).squaredNorm(), size2 = f_T_W.squaredNorm();
  if (cut2 <= kRounding * kRounding * size2) return f_T_W;
  return rendered_T_W.squaredNorm() <= size2 ? rendered_T_W : Vec3::Zero();
}

Vec3 limitEdge(const Limits& limits, const Motion& motion, const Vec3& f_T_W) noexcept {
  const double least_rad = std::min(leastOf(motion.room_above_rad), leastOf(motion.room_below_rad));
  if (!(limits.edge_rad > 0.0) || least_rad >= limits.edge_rad) return f_T_W;
  const Vec3 torque_N_m = motion.J_p.transpose() * f_T_W;
  double keep = 1.0;
  for (Eigen::Index joint = 0; joint < 3; ++joint) {
    const double room_rad = torque_N_m[joint] > 0.0   ? motion.room_above_rad[joint]
                            : torque_N_m[joint] < 0.0 ? motion.room_below_rad[joint]
                                                      : kInfinity;
    keep = std::min(keep, std::clamp(room_rad / limits.edge_rad, 0.0, 1.0));
  }
  return keep < 1.0 ? Vec3(keep * f_T_W) : f_T_W;
}

Vec3 limitHeat(const Thermal& thermal, const Vec3& heat, const Mat3& J_p, const Vec3& f_T_W) noexcept {
  if (!(heat.x() > kWarm || heat.y() > kWarm || heat.z() > kWarm)) return f_T_W;
  const Vec3 torque_N_m = J_p.transpose() * f_T_W;
  double keep = 1.0;
  for (Eigen::Index motor = 0; motor < 3; ++motor) {
    const double bears_N_m = thermal.continuous_N_m[motor];
    const double size_N_m = std::abs(torque_N_m[motor]);
    if (!(bears_N_m > 0.0) || !(heat[motor] > kWarm) || !(size_N_m > 0.0)) continue;
    const double times = 1.0 + std::max(0.0, 1.0 - heat[motor]) / (heat[motor] - kWarm);
    keep = std::min(keep, times * bears_N_m / size_N_m);
  }
  return keep < 1.0 ? Vec3(keep * f_T_W) : f_T_W;
}

Vec3 heated(const Thermal& thermal, const Vec3& heat, const Mat3& J_p, const Vec3& f_T_W, double dt_s) noexcept {
  if (!(dt_s > 0.0) || !(thermal.time_constant_s > 0.0)) return heat;
  const Vec3 torque_N_m = J_p.transpose() * f_T_W;
  const double share = std::min(1.0, dt_s / thermal.time_constant_s);
  Vec3 next = heat;
  for (Eigen::Index motor = 0; motor < 3; ++motor) {
    const double bears_N_m = thermal.continuous_N_m[motor];
    if (!(bears_N_m > 0.0)) continue;
    const double load = torque_N_m[motor] / bears_N_m;
    const double warmer = heat[motor] + share * (load * load - heat[motor]);
    if (std::isfinite(warmer)) next[motor] = warmer;
  }
  return next;
}

Vec3 limitSlew(const Limits& limits, const Vec3& last_T_W, const Vec3& f_T_W, double dt_s) noexcept {
  const double most_N = limits.max_slew_N_per_s * std::max(0.0, dt_s);
  const Vec3 way_N = f_T_W - last_T_W;
  const double square = way_N.squaredNorm();
  if (!(square > most_N * most_N)) return f_T_W;  // an infinite limit times 0 s is not a number, and limits nothing
  return last_T_W + (most_N / std::sqrt(square)) * way_N;
}

}  // namespace underact::safety
