#include "core/arm/forward.h"

#include "core/arm/axes.h"
#include "core/arm/general_arm.h"
#include "core/arm/wrist.h"
#include "core/base/trig.h"

namespace underact::arm {
namespace {

/// A point of B, given by its radius from axis 1, its height, and joint 1, in W.
Vec3 inWorkspace(const Geometry& geometry, const SinCos& turret, double reach_m, double height_m) noexcept {
  return {geometry.p_WB.x() + turret.sin * reach_m, geometry.p_WB.y() + height_m,
          geometry.p_WB.z() + turret.cos * reach_m};
}

}  // namespace

Vec3 tipPosition(const Geometry& geometry, const JointAngles& q_rad) noexcept {
  if (geometry.general != nullptr) return chain::forward(geometry.general->chain, q_rad).translation();
  const Plane at = planeOf(geometry, q_rad);
  return inWorkspace(geometry, at.turret, at.out_m, at.up_m);
}

Skeleton skeleton(const Geometry& geometry, const JointAngles& q_rad) noexcept {
  if (geometry.general != nullptr) {
    const chain::Chain& chain = geometry.general->chain;
    std::array<Pose, chain::kMaxJoints> X_WLinks;
    const Vec3 p_WT = chain::forward(chain, q_rad, X_WLinks).translation();
    const std::size_t middle = chain.joints.size() / 2;
    return {chain.joints.front().p_WJ, X_WLinks[middle] * chain.joints[middle].p_WJ, p_WT};
  }
  const SinCos turret = sinCos(q_rad[0]), thigh = sinCos(q_rad[1]);
  return {geometry.p_WB, inWorkspace(geometry, turret, geometry.upper_m * thigh.cos, geometry.upper_m * thigh.sin),
          tipPosition(geometry, q_rad)};
}

Mat3 workspaceFromBase() noexcept {
  Mat3 R_WB;
  R_WB << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  return R_WB;
}

Mat3 baseFromForearm(const JointAngles& q_rad) noexcept {
  return forearmRotation(sinCos(q_rad[0]), sinCos(q_rad[1] + q_rad[2]));
}

Pose tipPose(const Geometry& geometry, const JointAngles& q_rad) noexcept {
  if (geometry.general != nullptr) return chain::forward(geometry.general->chain, q_rad);
  const Plane at = planeOf(geometry, q_rad);
  Pose X_WT = Pose::Identity();
  X_WT.linear() = axesOf(at, q_rad).R_WT;
  X_WT.translation() = inWorkspace(geometry, at.turret, at.out_m, at.up_m);
  return X_WT;
}

}  // namespace underact::arm
