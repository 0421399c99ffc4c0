#pragma once
#include <span>
#include <vector>

#include "core/manipulator/manipulator.h"

namespace underact::gui {

/// A joint of a virtual manipulator where it stands, m, in W.
struct JointFigure {
  chain::JointType type = chain::JointType::Revolute;
  Vec3 from_W = Vec3::Zero();  // where the joint is on the link before it
  Vec3 to_W = Vec3::Zero();    // and on its own link: elsewhere only where a sliding joint has slid
  Vec3 axis_W = Vec3::UnitZ();
  bool has_spring = false;
  int at_same_place = 0;  // how many joints before it cross it in one point
};

/// A virtual manipulator as a drawing of machines has it: from joint to joint to the tip V. m, in W.
struct RobotFigure {
  std::vector<JointFigure> joints;
  Pose X_WV = Pose::Identity();
};

/// theta: rad or m, as many as there are joints. A joint that turns stands at the point that the scene gives; one that
/// slides has none: it stands where its axis, taken through the next point of the chain, is nearest to the one before.
RobotFigure figureOf(const manipulator::Manipulator& manipulator, std::span<const double> theta);

/// Which ways the tip can go without the links being bent: the range of the translational part of its Jacobian.
struct Freedom {
  int rank = 0;                          // 0 to 3
  Mat3 directions_W = Mat3::Identity();  // the first `rank` columns span them, the easiest first
  Vec3 reach_m_per_rad = Vec3::Zero();   // singular values, falling
};

/// A direction counts as lost where a radian of joint turn (or the reach's own length of a slide) moves the tip by less
/// than this share of the reach: less is not seen in a picture.
inline constexpr double kLostShare = 0.02;

Freedom freedomOf(const manipulator::Manipulator& manipulator, std::span<const double> theta);

}  // namespace underact::gui
