#include "core/arm/forward.h"

#include "core/arm/jacobian.h"
#include "core/arm/mechanism.h"
#include "core/arm/wrist.h"
#include "core/base/trig.h"

namespace underact::arm {

Vec3 tipPosition(const Geometry& geometry, const JointAngles& q_rad) noexcept {
  return kinematics(geometry, q_rad, {false, false}).X_WT.translation();
}

Pose tipPose(const Geometry& geometry, const JointAngles& q_rad) noexcept {
  return kinematics(geometry, q_rad, {true, false}).X_WT;
}

Vec3 workspaceMiddle(const Geometry& geometry) noexcept {
  return solvesInTick(geometry) ? Vec3(Vec3::Zero()) : tipPosition(geometry, geometry.mechanism->rest);
}

Skeleton skeleton(const Geometry& geometry, const JointAngles& q_rad) noexcept {
  if (geometry.by_chain) {
    const chain::Chain& chain = geometry.mechanism->chain;
    std::array<Pose, chain::kMaxJoints> X_WLinks;
    const Vec3 p_WT = chain::forward(chain, q_rad, X_WLinks).translation();
    const std::size_t middle = chain.joints.size() / 2;
    return {chain.joints.front().p_WJ, X_WLinks[middle] * chain.joints[middle].p_WJ, p_WT};
  }
  const SinCos turret = sinCos(q_rad[0]), thigh = sinCos(q_rad[1]);
  const double out_m = geometry.upper_m * thigh.cos;
  const Vec3 p_BElbow_W(turret.sin * out_m, geometry.upper_m * thigh.sin, turret.cos * out_m);
  return {geometry.p_WB, geometry.p_WB + p_BElbow_W, tipPosition(geometry, q_rad)};
}

Mat3 workspaceFromBase() noexcept {
  Mat3 R_WB;
  R_WB << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  return R_WB;
}

Mat3 baseFromForearm(const JointAngles& q_rad) noexcept {
  return forearmRotation(sinCos(q_rad[0]), sinCos(q_rad[1] + q_rad[2]));
}

}  // namespace underact::arm
