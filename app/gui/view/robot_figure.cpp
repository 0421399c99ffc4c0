#include "app/gui/view/robot_figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/decompositions.h"
#include "core/chain/kinematics.h"

namespace underact::gui {
namespace {

using chain::JointType;

constexpr double kSamePlace_m = 1e-4;

/// The point of each joint in the home pose.
std::vector<Vec3> placesAtHome(const chain::Chain& chain) {
  std::vector<Vec3> places(chain.joints.size());
  Vec3 next_W = chain.X_WT_home.translation();
  std::vector<Vec3> after(chain.joints.size());  // the next point that the chain defines
  for (std::size_t back = chain.joints.size(); back-- > 0;) {
    after[back] = next_W;
    if (chain.joints[back].type == JointType::Revolute) next_W = chain.joints[back].p_WJ;
  }
  for (std::size_t index = 0; index < chain.joints.size(); ++index) {
    const chain::Joint& joint = chain.joints[index];
    if (joint.type == JointType::Revolute) {
      places[index] = joint.p_WJ;
    } else {
      const Vec3 before_W = index > 0 ? places[index - 1] : after[index];
      places[index] = after[index] + joint.axis_W.dot(before_W - after[index]) * joint.axis_W;
    }
  }
  return places;
}

}  // namespace

RobotFigure figureOf(const manipulator::Manipulator& manipulator, std::span<const double> theta) {
  const chain::Chain& chain = manipulator.chain;
  RobotFigure figure;
  std::array<Pose, chain::kMaxJoints> X_WLinks;
  figure.X_WV = chain::forward(chain, theta, X_WLinks);
  const std::vector<Vec3> places = placesAtHome(chain);
  for (std::size_t index = 0; index < places.size(); ++index) {
    const Pose X_before = index > 0 ? X_WLinks[index - 1] : Pose::Identity();
    JointFigure joint;
    joint.type = chain.joints[index].type;
    joint.from_W = X_before * places[index];
    joint.to_W = X_WLinks[index] * places[index];
    joint.axis_W = X_before.linear() * chain.joints[index].axis_W;
    joint.has_spring = manipulator.spring[index] > 0.0;
    for (const JointFigure& other : figure.joints) {
      if ((other.to_W - joint.from_W).norm() < kSamePlace_m) ++joint.at_same_place;
    }
    figure.joints.push_back(joint);
  }
  return figure;
}

Freedom freedomOf(const manipulator::Manipulator& manipulator, std::span<const double> theta) {
  const chain::Jacobian J = chain::jacobian(manipulator.chain, theta);
  Mat3 JJt = Mat3::Zero();
  for (Eigen::Index column = 0; column < J.cols(); ++column) {
    const bool slides = manipulator.chain.joints[static_cast<std::size_t>(column)].type == JointType::Prismatic;
    const Vec3 v = (slides ? manipulator.reach_m : 1.0) * J.col(column).head<3>();
    JJt += v * v.transpose();
  }
  Freedom freedom;
  if (!JJt.allFinite()) return freedom;
  const PrincipalAxes principal = principalAxes(JJt);
  for (Eigen::Index index = 0; index < 3; ++index) {
    freedom.directions_W.col(index) = principal.axes.col(2 - index);
    freedom.reach_m_per_rad[index] = std::sqrt(std::max(0.0, principal.values[2 - index]));
    if (freedom.reach_m_per_rad[index] > kLostShare * manipulator.reach_m) ++freedom.rank;
  }
  return freedom;
}

}  // namespace underact::gui
