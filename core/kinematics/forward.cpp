#include "core/kinematics/forward.h"

#include <algorithm>
#include <cmath>

#include "core/arm/branches.h"
#include "core/arm/forward.h"
#include "core/arm/jacobian.h"
#include "core/base/units.h"
#include "core/chain/kinematics.h"
#include "core/chain/statics.h"
#include "core/kinematics/units.h"

namespace underact::kinematics {
namespace {

using chain::JointValues;

constexpr double kNoVolume_mm3 = 1e-6;  // a determinant under it is the rounding of the angles

/// The joints of an Omni's straight-line code.
arm::JointAngles sixOf(const JointValues& q) noexcept {
  arm::JointAngles q_rad{};
  std::copy_n(q.begin(), q_rad.size(), q_rad.begin());
  return q_rad;
}

std::span<const double> onlyJoints(const SolvedArm& arm, const JointValues& q) noexcept {
  return std::span(q).first(arm.joints());
}

/// Of six joints that all turn, in m.
Mat6 jacobianOfSix(const SolvedArm& arm, const JointValues& q) noexcept {
  return arm.omni ? arm::kinematics(*arm.omni, sixOf(q)).J : chain::jacobian(arm.flange, onlyJoints(arm, q));
}

/// Which singularities the joints of an arm of six are at.
std::vector<const char*> singularities(const SolvedArm& arm, const JointValues& q, const Mat6& J, double det_Jp_m3) {
  std::vector<const char*> names;
  if (arm.omni) {
    const arm::SingularityDistances at = arm::singularityDistances(*arm.omni, sixOf(q));
    if (at.shoulder_m < arm::kSingularDistance_m) names.push_back("shoulder");
    if (at.elbow_rad < arm::kSingularSine) names.push_back("elbow");
    if (at.wrist_rad < arm::kSingularSine) names.push_back("wrist");
    return names;
  }
  const double reach_m = chain::reachOf(arm.flange);
  if (std::abs(det_Jp_m3) < arm::kSingularSine * reach_m * reach_m * reach_m) names.push_back("position");
  if (arm.closed && std::abs(J.bottomRightCorner<3, 3>().determinant()) < arm::kSingularSine) names.push_back("wrist");
  return names;
}

/// Of six joints that all turn: by the block of the first three.
Dexterity dexterityOfSix(const SolvedArm& arm, const JointValues& q) {
  const Mat6 J = jacobianOfSix(arm, q);
  const Mat3 Jp = J.topLeftCorner<3, 3>();
  const double det_m3 = arm.omni ? arm::dexterity(*arm.omni, sixOf(q)).det_m3 : Jp.determinant();
  const double det_mm3 = det_m3 * 1e9;
  double condition = kNotANumber;
  if (std::abs(det_mm3) >= kNoVolume_mm3) {
    const Vec3 gain_m = arm.omni ? arm::dexterity(*arm.omni, sixOf(q)).gain_m : Vec3(Jp.jacobiSvd().singularValues());
    condition = gain_m[0] / gain_m[2];
  }
  return {det_mm3, std::abs(det_mm3), condition, singularities(arm, q, J, det_m3)};
}

}  // namespace

bool sixTurn(const SolvedArm& arm) noexcept {
  const std::vector<chain::Joint>& joints = arm.chain().joints;
  return joints.size() == 6 && std::all_of(joints.begin(), joints.end(), turns);
}

Eigen::Matrix4d poseOf(const SolvedArm& arm, const JointValues& q) noexcept {
  return matrixOf(arm.omni ? arm::tipPose(*arm.omni, sixOf(q)) : chain::forward(arm.chain(), onlyJoints(arm, q)));
}

Eigen::MatrixXd jacobianOf(const SolvedArm& arm, const JointValues& q) {
  Eigen::MatrixXd J = sixTurn(arm) ? Eigen::MatrixXd(jacobianOfSix(arm, q))
                                   : Eigen::MatrixXd(chain::jacobian(arm.flange, onlyJoints(arm, q)));
  J.topRows(3) *= kMillimetrePerMetre;
  for (std::size_t i = 0; i < arm.joints(); ++i) {
    if (!turns(arm.chain().joints[i])) J.col(static_cast<Eigen::Index>(i)) *= kMetrePerMillimetre;
  }
  return J;
}

Dexterity dexterityOf(const SolvedArm& arm, const JointValues& q) {
  if (sixTurn(arm)) return dexterityOfSix(arm, q);
  const chain::Jacobian J = chain::jacobian(arm.flange, onlyJoints(arm, q));
  const chain::Ellipsoid all = chain::positionEllipsoid(J, {});
  Dexterity found;
  found.det_mm3 = kNotANumber;
  found.manipulability =
      all.manipulability * std::pow(kMillimetrePerMetre, std::min(3.0, static_cast<double>(J.cols())));
  found.condition = std::isfinite(all.condition) ? all.condition : kNotANumber;
  if (all.gain[std::min<std::size_t>(3, arm.joints()) - 1] < arm::kSingularSine * chain::reachOf(arm.flange))
    found.singular.push_back("position");
  return found;
}

}  // namespace underact::kinematics
