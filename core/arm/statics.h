#pragma once
#include "core/arm/preset.h"
#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::arm {

/// The torques of joints 1 to 3, N m, for a force f_T_W, N, of the arm on the tip. Source: tau = J_p^T f.
Vec3 torqueOf(const Geometry& geometry, const JointAngles& q_rad, const Vec3& f_T_W) noexcept UNDERACT_REAL_TIME;

/// Torques of all six joints for the wrench (force, N; moment, N m) at the tip, in W: tau = J^T F.
Vec6 torqueOf(const Mat6& J, const Vec6& wrench_T_W) noexcept UNDERACT_REAL_TIME;

/// The force on the tip of torques of joints 1 to 3, and its error.
struct ForceOfTorque {
  Vec3 f_T_W = Vec3::Zero();      // N
  double damping_m = 0.0;         // lambda; 0: exact
  double torque_error_N_m = 0.0;  // |J_p^T f - tau|: what the damping leaves out
};
/// Exact where the smallest gain of J_p is at least kDampedBelow_m; closer to a singularity, damped least squares:
/// f = (J_p J_p^T + lambda^2 I)^-1 J_p tau with lambda^2 = kDamping_m^2 (1 - (gain / kDampedBelow_m)^2), so that the
/// force stays below |tau| / (2 lambda) and does not grow without bound. The damping sets in continuously. At the
/// singularity itself the force along the lost direction is 0. Within 16 ulp of |tau| g^3 / (s^2 + lambda^2)^2, g the
/// largest and s the smallest gain. Source: Nakamura and Hanafusa 1986; Maciejewski and Klein 1988.
ForceOfTorque forceOf(const Geometry& geometry, const JointAngles& q_rad,
                      const Vec3& torque_N_m) noexcept UNDERACT_REAL_TIME;

inline constexpr double kDampedBelow_m = 0.02;  // gains at the middle of the workspace are 0.08 to 0.18 m
inline constexpr double kDamping_m = 0.01;

}  // namespace underact::arm
