#include "core/arm/forward.h"

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
  const auto [turret, thigh] = sinCosOfTwo(q_rad[0], q_rad[1]);
  const SinCos shin = sinCosOfTwo(q_rad[1] + q_rad[2], 0.0).first;
  const double reach_m = geometry.upper_m * thigh.cos + geometry.fore_m * shin.sin;   // eq. 3.5
  const double height_m = geometry.upper_m * thigh.sin - geometry.fore_m * shin.cos;  // eq. 3.5
  return inWorkspace(geometry, turret, reach_m, height_m);
}

Skeleton skeleton(const Geometry& geometry, const JointAngles& q_rad) noexcept {
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
  const SinCos one = sinCos(q_rad[0]), shin = sinCos(q_rad[1] + q_rad[2]);
  Mat3 R_B3;
  R_B3 << one.cos * shin.cos, one.sin, one.cos * shin.sin,  //
      one.sin * shin.cos, -one.cos, one.sin * shin.sin,     //
      shin.sin, 0.0, -shin.cos;
  return R_B3;
}

Pose tipPose(const Geometry& geometry, const JointAngles& q_rad) noexcept {
  const SinCos four = sinCos(q_rad[3]), five = sinCos(q_rad[4]), six = sinCos(q_rad[5]);
  Mat3 R_36;  // eq. 3.6 with its erratum
  R_36 << four.cos * five.cos * six.cos - four.sin * six.sin, -four.cos * five.cos * six.sin - four.sin * six.cos,
      four.cos * five.sin,  //
      four.sin * five.cos * six.cos + four.cos * six.sin, -four.sin * five.cos * six.sin + four.cos * six.cos,
      four.sin * five.sin,  //
      -five.sin * six.cos, five.sin * six.sin, five.cos;
  const Mat3 R_BT = baseFromForearm(q_rad) * R_36;
  Pose X_WT = Pose::Identity();
  X_WT.linear() << R_BT.row(1), R_BT.row(2), R_BT.row(0);  // R_WB, a permutation
  X_WT.translation() = tipPosition(geometry, q_rad);
  return X_WT;
}

}  // namespace underact::arm
