#include "core/arm/statics.h"

#include <cmath>

#include "core/arm/jacobian.h"

namespace underact::arm {

Vec3 torqueOf(const Geometry& geometry, const JointAngles& q_rad, const Vec3& f_T_W) noexcept {
  return positionJacobian(geometry, q_rad).transpose() * f_T_W;
}

Vec6 torqueOf(const Mat6& J, const Vec6& wrench_T_W) noexcept {
  return J.transpose() * wrench_T_W;
}

ForceOfTorque forceOf(const Geometry& geometry, const JointAngles& q_rad, const Vec3& torque_N_m) noexcept {
  const Dexterity dexterity = arm::dexterity(geometry, q_rad);
  const Mat3& J = dexterity.J;
  const double share = dexterity.gain_m[2] / kDampedBelow_m;
  ForceOfTorque result;
  if (share < 1.0) result.damping_m = kDamping_m * std::sqrt((1.0 - share) * (1.0 + share));
  // In the principal axes the inverse is three divisions: no factorisation, and as accurate as the axes.
  const Vec3 pushed_W = dexterity.axes_W.transpose() * (J * torque_N_m);
  const double damping = result.damping_m * result.damping_m;
  Vec3 along;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double stiffness = dexterity.gain_m[axis] * dexterity.gain_m[axis] + damping;
    along[axis] = stiffness > 0.0 ? pushed_W[axis] / stiffness : 0.0;
  }
  result.f_T_W = dexterity.axes_W * along;
  if (result.damping_m > 0.0) result.torque_error_N_m = (J.transpose() * result.f_T_W - torque_N_m).norm();
  return result;
}

}  // namespace underact::arm
