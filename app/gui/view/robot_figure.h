#pragma once
#include <span>
#include <vector>

#include "core/manipulator/manipulator.h"

namespace underact::gui {

/// A joint of a virtual robot at its current pose, m, in W.
struct JointFigure {
  chain::JointType type = chain::JointType::Revolute;
  Vec3 from_W = Vec3::Zero();  // the joint on the link before it
  Vec3 to_W = Vec3::Zero();    // and on its own link: differs only by the displacement of a prismatic joint
  Vec3 axis_W = Vec3::UnitZ();
  bool has_spring = false;
  int at_same_place = 0;  // how many joints before it intersect it in one point
};

/// A virtual robot as a mechanical drawing: from joint to joint to the end effector V. m, in W.
struct RobotFigure {
  std::vector<JointFigure> joints;
  Pose X_WV = Pose::Identity();
};

/// theta: rad or m, one for each joint. A revolute joint is drawn at the point given by the scene. A prismatic one has
/// none: it is drawn where its axis, taken through the next point of the chain, is nearest to the one before.
RobotFigure figureOf(const manipulator::Manipulator& manipulator, std::span<const double> theta);

/// The directions in which the joints can move V: the range of the translational part of its Jacobian.
struct Freedom {
  int rank = 0;                          // 0 to 3
  Mat3 directions_W = Mat3::Identity();  // the first `rank` columns span them, the easiest first
  Vec3 reach_m_per_rad = Vec3::Zero();   // singular values, in descending order
};

/// A direction counts as lost if a radian of joint rotation (or a displacement of the reach's length) moves V by less
/// than this share of the reach: less is not visible in a picture.
inline constexpr double kLostShare = 0.02;

Freedom freedomOf(const manipulator::Manipulator& manipulator, std::span<const double> theta);

}  // namespace underact::gui
