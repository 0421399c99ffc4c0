#include "core/arm/mirror.h"

#include <cmath>

namespace underact::arm {
namespace {

constexpr double kUprightPart = 1e-6;  // horizontal part of a direction that counts as upright
constexpr double kOnAxis_m = 1e-12;    // rounding of a base that stands on the axes of W

/// The axis of W, 0 or 1, along which the arm faces.
Eigen::Index facingAxis(const Model& model) {
  const bool has_table = model.form == ArmForm::ModifiedDh || model.form == ArmForm::ClassicDh;
  if (!has_table) return 0;
  const Mat3 R_WB = model.X_WB.linear();
  const Vec3 forward_W = R_WB.col(0).head<2>().norm() > kUprightPart ? R_WB.col(0) : R_WB.col(2);
  return std::abs(forward_W.x()) >= std::abs(forward_W.y()) ? 0 : 1;
}

}  // namespace

Vec3 MirrorPlane::positionSeen(Vec3 p_W) const noexcept {
  p_W[axis] = 2.0 * at_m - p_W[axis];
  return p_W;
}

Vec3 MirrorPlane::directionSeen(Vec3 direction_W) const noexcept {
  direction_W[axis] = 0.0 - direction_W[axis];  // never -0
  return direction_W;
}

MirrorPlane mirrorPlane(const Model& model) {
  if (omniGeometry(model)) return {};
  const Eigen::Index across = 1 - facingAxis(model);
  const chain::Joint& first = model.chain.joints.front();
  // A base that turns about the vertical stands where its axis does, whatever the file calls frame 0.
  const bool is_upright = first.type == chain::JointType::Revolute && first.axis_W.head<2>().norm() < kUprightPart;
  const double at_m = (is_upright ? first.p_WJ : Vec3(model.X_WB.translation()))[across];
  return {across, std::abs(at_m) < kOnAxis_m ? 0.0 : at_m};
}

}  // namespace underact::arm
