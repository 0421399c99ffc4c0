#include "core/safety/stages.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/norms.h"

namespace underact::safety {
namespace {

constexpr double kVelocityFilter_s = 5e-3;
constexpr double kRounding = 1e-12;  // of what is rendered whole

/// The torque of a driven joint, N m (the force, N, where it slides).
double torqueAt(const Motion& motion, std::size_t joint, const Wrench& wrench) noexcept UNDERACT_REAL_TIME {
  const double of_force = motion.joints[joint].J_v.dot(wrench.f_T_W);
  return motion.turns ? of_force + motion.joints[joint].J_w.dot(wrench.m_T_W) : of_force;
}

/// What is rendered of `asked`: that itself where it is all but a rounding of it; nothing where it overflows.
template <class Vector>
Vector renderedOf(const Vector& asked, const Vector& rendered) noexcept UNDERACT_REAL_TIME {
  if (!rendered.allFinite()) return Vector::Zero();
  const double cut2 = (asked - rendered).squaredNorm(), size2 = asked.squaredNorm();
  if (cut2 <= kRounding * kRounding * size2) return asked;
  return rendered.squaredNorm() <= size2 ? rendered : Vector(Vector::Zero());
}

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

Wrench limitMotors(const Motion& motion, const Wrench& wrench) noexcept {
  if (motion.turns) {
    Vec6 scaled;
    scaled << kMomentArm_m * wrench.f_T_W, wrench.m_T_W;
    const Vec6 rendered = renderedOf<Vec6>(scaled, motion.renders_wrench * scaled);
    return rendered == scaled ? wrench : Wrench{rendered.head<3>() / kMomentArm_m, rendered.tail<3>()};
  }
  if (motion.renders_all) return {wrench.f_T_W, Vec3::Zero()};
  return {renderedOf<Vec3>(wrench.f_T_W, motion.renders * wrench.f_T_W), Vec3::Zero()};
}

double edgeShare(const Limits& limits, const Motion& motion, const Wrench& wrench) noexcept {
  double keep = 1.0;
  for (std::size_t joint = 0; limits.edge_rad > 0.0 && joint < motion.count; ++joint) {
    const DrivenJoint& driven = motion.joints[joint];
    if (std::min(driven.room_below_rad, driven.room_above_rad) >= limits.edge_rad) continue;
    const double torque = torqueAt(motion, joint, wrench);
    const double room_rad = torque > 0.0 ? driven.room_above_rad : torque < 0.0 ? driven.room_below_rad : kInfinity;
    keep = std::min(keep, std::clamp(room_rad / limits.edge_rad, 0.0, 1.0));
  }
  return keep;
}

double torqueShare(const Limits& limits, const Heat& heat, const Motion& motion, const Wrench& wrench) noexcept {
  double keep = 1.0;
  for (std::size_t joint = 0; joint < motion.count; ++joint) {
    const double bears = limits.thermal.continuous_N_m[joint], max = limits.max_torque_N_m[joint];
    const bool is_warm = bears > 0.0 && heat[joint] > kWarm;
    if (!is_warm && max == kInfinity) continue;
    const double size = std::abs(torqueAt(motion, joint, wrench));
    if (!(size > 0.0)) continue;
    keep = std::min(keep, max / size);
    if (is_warm) keep = std::min(keep, (1.0 + std::max(0.0, 1.0 - heat[joint]) / (heat[joint] - kWarm)) * bears / size);
  }
  return keep;
}

Heat heated(const Thermal& thermal, const Heat& heat, const Motion& motion, const Wrench& wrench,
            double dt_s) noexcept {
  if (!(dt_s > 0.0) || !(thermal.time_constant_s > 0.0)) return heat;
  const double share = std::min(1.0, dt_s / thermal.time_constant_s);
  Heat next = heat;
  for (std::size_t joint = 0; joint < next.size(); ++joint) {
    const double bears = thermal.continuous_N_m[joint];
    if (!(bears > 0.0)) continue;
    const double load = joint < motion.count ? torqueAt(motion, joint, wrench) / bears : 0.0;
    const double warmer = heat[joint] + share * (load * load - heat[joint]);
    if (std::isfinite(warmer)) next[joint] = warmer;
  }
  return next;
}

Vec3 limitSlew(const Limits& limits, const Vec3& last_T_W, const Vec3& f_T_W, double dt_s) noexcept {
  const double max_N = limits.max_slew_N_per_s * std::max(0.0, dt_s);
  const Vec3 change_N = f_T_W - last_T_W;
  const double square = change_N.squaredNorm();
  if (!(square > max_N * max_N)) return f_T_W;  // an infinite limit times 0 s is not a number, and limits nothing
  return last_T_W + (max_N / std::sqrt(square)) * change_N;
}

}  // namespace underact::safety
