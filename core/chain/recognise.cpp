#include <cmath>

#include "core/base/axis_geometry.h"
#include "core/chain/closed_form.h"
#include "core/chain/rotation.h"
#include "core/chain/trig_equation.h"

namespace underact::chain {
namespace {

bool sixTurning(const std::vector<Joint>& joints) noexcept {
  for (const Joint& joint : joints) {
    if (joint.type != JointType::Revolute) return false;
  }
  return joints.size() == 6;
}

/// Whether the angles between the axes are those of such an arm.
bool hasTheAngles(const std::vector<Joint>& joints) noexcept {
  const auto parallel = [&](std::size_t a, std::size_t b) {
    return areParallel(joints[a - 1].axis_W, joints[b - 1].axis_W);
  };
  return parallel(2, 3) && !parallel(1, 2) && !parallel(4, 5) && !parallel(5, 6);
}

}  // namespace

std::optional<SphericalWristArm> recognise(const Chain& chain) noexcept {
  const std::vector<Joint>& joints = chain.joints;
  if (!sixTurning(joints) || !hasTheAngles(joints)) return std::nullopt;
  const double near_m = kSame * reachOf(chain);
  const std::optional<Vec3> centre = meetingPoint(std::span(joints).last<3>(), near_m);
  if (!centre) return std::nullopt;
  const Vec3 p_WC = *centre;

  SphericalWristArm arm;
  for (std::size_t i = 0; i < 6; ++i) arm.axis_W[i] = joints[i].axis_W;
  const Vec3& axis_2_W = arm.axis_W[1];
  arm.p_WJ1 = nearestOn(joints[0], joints[1]);
  arm.offset_W = perpendicularPart(axis_2_W, joints[1].p_WJ - arm.p_WJ1);
  arm.upper_W = perpendicularPart(axis_2_W, joints[2].p_WJ - joints[1].p_WJ);
  arm.fore_W = perpendicularPart(axis_2_W, p_WC - joints[2].p_WJ);
  arm.upper_m = arm.upper_W.norm();
  arm.fore_m = arm.fore_W.norm();
  if (!(arm.upper_m > near_m && arm.fore_m > near_m)) return std::nullopt;
  arm.along_m = axis_2_W.dot(p_WC - arm.p_WJ1);
  arm.sense = axis_2_W.dot(arm.axis_W[2]) > 0.0 ? 1.0 : -1.0;
  arm.wrist = wristAxes(arm.axis_W[3], arm.axis_W[4], arm.axis_W[5]);
  arm.elbow_middle_rad = angleAbout(arm.axis_W[2], arm.fore_W, arm.upper_W);
  arm.R_TW = chain.X_WT_home.linear().transpose();
  arm.p_TC = arm.R_TW * (p_WC - chain.X_WT_home.translation());
  arm.reach_m = arm.offset_W.norm() + std::abs(arm.along_m) + arm.upper_m + arm.fore_m;
  return arm;
}

}  // namespace underact::chain
