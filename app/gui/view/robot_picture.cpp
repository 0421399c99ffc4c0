#include "app/gui/view/robot_picture.h"

#include <vtkProperty.h>

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/units.h"
#include "core/scene/compile.h"

namespace underact::gui {
namespace {

constexpr double kRobotJoint_mm = 4.2, kMinJoint_mm = 2.6;  // its radius; smaller for a small robot
constexpr double kOfReach = 0.07;
constexpr double kCrossing = 0.72;  // a joint that intersects another is this much smaller
constexpr double kZ_mm = 16.0, kFrame_mm = 14.0, kAxisHead_mm = 3.0;
constexpr double kMomentRadius_mm = 17.0;
constexpr double kMinMoment_N_mm = 2.0;
constexpr int kTurns = 2, kSpringParts = 40, kArcParts = 48;

Vec3 millimetresOf(const Vec3& p_W) {
  return kMillimetrePerMetre * p_W;
}

/// The direction perpendicular to `axis` that is nearest to `wish`.
Vec3 acrossTowards(const Vec3& axis, const Vec3& towards) {
  const Vec3 across = towards - towards.dot(axis) * axis;
  return across.norm() > 1e-3 ? Vec3(across.normalized()) : axis.unitOrthogonal();
}

void addArrow(Lines& lines, const Vec3& from_mm, const Vec3& to_mm, const Vec3& back_W, const QColor& colour) {
  const Vec3 direction = (to_mm - from_mm).normalized();
  const Vec3 side = acrossTowards(direction, direction.cross(back_W));
  lines.segment(from_mm, to_mm, colour);
  lines.segment(to_mm, to_mm - kAxisHead_mm * direction + 0.6 * kAxisHead_mm * side, colour);
  lines.segment(to_mm, to_mm - kAxisHead_mm * direction - 0.6 * kAxisHead_mm * side, colour);
}

/// From rim to rim: hollow joints are not crossed out.
void addLink(Lines& lines, const Vec3& a_mm, double a_rim_mm, const Vec3& b_mm, double b_rim_mm, const QColor& colour) {
  const Vec3 travel_mm = b_mm - a_mm;
  if (travel_mm.norm() <= a_rim_mm + b_rim_mm) return;  // intersecting axes: no link is visible
  const Vec3 direction = travel_mm.normalized();
  lines.segment(a_mm + a_rim_mm * direction, b_mm - b_rim_mm * direction, colour);
}

}  // namespace

RobotPicture::RobotPicture()
    : thin_actor_(makeActor(thin_.data(), PieceKind::Line)), thick_actor_(makeActor(thick_.data(), PieceKind::Line)) {}

void RobotPicture::setLineWidth(double scale) {
  thin_actor_->GetProperty()->SetLineWidth(static_cast<float>(1.5 * scale));
  thick_actor_->GetProperty()->SetLineWidth(static_cast<float>(3.0 * scale));
}

void RobotPicture::setScene(const scene::Description& scene) {
  const std::vector<Robot> before = std::exchange(robots_, {});
  const Result<tick::TickProgram> program = scene::compile(scene);
  if (!program) return;
  is_sent_ = program.value().needs.moment;
  for (std::size_t index = 0; index < program.value().entries.size(); ++index) {
    const auto* made = std::get_if<manipulator::Manipulator>(&program.value().entries[index].constraint.goal);
    if (made == nullptr) continue;
    Robot robot;
    robot.index = index;
    robot.manipulator = *made;
    robot.theta = manipulator::clampedToLimits(*made, {});
    for (const Robot& old : before) {  // edited: it keeps its pose until the servo reports a new one
      const bool alike = old.manipulator.chain.joints.size() == made->chain.joints.size();
      if (old.index == index && alike) robot.theta = manipulator::clampedToLimits(*made, old.theta);
    }
    robot.body->setOrder(static_cast<int>(robots_.size()));
    robot.body->setChain(made->chain);
    robots_.push_back(robot);
  }
}

void RobotPicture::present(const servo::Snapshot& snapshot) {
  const tick::TickReport& report = snapshot.report;
  for (Robot& robot : robots_) {
    if (robot.index >= report.held.size()) continue;
    const target::Robot& now = report.held[robot.index].robot;
    if (now.joints != robot.manipulator.chain.joints.size()) continue;
    if (!std::all_of(now.theta.begin(), now.theta.end(), [](double q) { return std::isfinite(q); })) continue;
    robot.theta = now.theta;
    robot.moment_W = report.held[robot.index].acts ? now.moment_W : Vec3::Zero();
  }
  p_WT_ = report.p_WT;
  known_ = snapshot.ticks > 0 || report.held.size() > 0;
}

std::vector<vtkActor*> RobotPicture::surfaces() const {
  std::vector<vtkActor*> surfaces;
  for (const Robot& robot : robots_) surfaces.push_back(robot.body->actor());
  return surfaces;
}

std::vector<Vec3> RobotPicture::extent_mm() const {
  std::vector<Vec3> points;
  if (!show_) return points;
  for (const Robot& robot : robots_) {
    const RobotFigure figure = figureOf(robot.manipulator, robot.theta);
    for (const JointFigure& joint : figure.joints) points.push_back(millimetresOf(joint.to_W));
    points.push_back(millimetresOf(figure.X_WV.translation()));
  }
  return points;
}

void RobotPicture::update(const OrbitCamera& camera) {
  thin_.clear();
  thick_.clear();
  labels_.clear();
  for (const Robot& robot : robots_) {
    robot.body->hide();
    if (show_) add(robot, camera);
  }
  thin_.done();
  thick_.done();
}

void RobotPicture::add(const Robot& robot, const OrbitCamera& camera) {
  const RobotFigure figure = figureOf(robot.manipulator, robot.theta);
  const double size_mm =
      std::clamp(kOfReach * kMillimetrePerMetre * robot.manipulator.reach_m, kMinJoint_mm, kRobotJoint_mm);
  const Vec3 tip_mm = millimetresOf(figure.X_WV.translation());
  robot.body->setColour(theme_.virtual_robot);
  robot.body->present(robot.theta);
  addBase(millimetresOf(figure.joints.front().from_W), size_mm, camera.right_W());
  Vec3 last_mm = millimetresOf(figure.joints.front().from_W);
  double rim_mm = size_mm;
  for (const JointFigure& joint : figure.joints) {
    const double own_mm = size_mm * std::pow(kCrossing, joint.at_same_place);
    addLink(thick_, last_mm, rim_mm, millimetresOf(joint.from_W), own_mm, theme_.virtual_robot);
    addJoint(joint, own_mm, camera.eye_mm());
    last_mm = millimetresOf(joint.to_W);
    rim_mm = own_mm;
  }
  addLink(thick_, last_mm, rim_mm, tip_mm, 0.0, theme_.virtual_robot);
  addTip(robot, figure.X_WV, camera);
  addDirections(robot, tip_mm, camera);
  if (known_) addMoment(robot.moment_W, camera);
}

void RobotPicture::addJoint(const JointFigure& joint, double size_mm, const Vec3& eye_mm) {
  const QColor colour = theme_.virtual_robot;
  const Vec3 u = joint.axis_W.unitOrthogonal(), v = joint.axis_W.cross(u);
  const Vec3 from_mm = millimetresOf(joint.from_W), to_mm = millimetresOf(joint.to_W);
  if (joint.type == chain::JointType::Revolute) {  // an open cylinder along the axis
    const Vec3 half_mm = 1.3 * size_mm * joint.axis_W;
    thick_.circle(to_mm - half_mm, u, v, size_mm, colour);
    thick_.circle(to_mm + half_mm, u, v, size_mm, colour);
    thick_.sides(eye_mm, to_mm - half_mm, to_mm + half_mm, size_mm, size_mm, colour);
  } else {  // an open box along the axis, and the rod that slides in it
    Mat3 R;
    R << u, v, joint.axis_W;
    addBoxEdges(thick_, Vec3(0.8, 0.8, 1.5) * size_mm, from_mm, R, colour);
    thin_.segment(from_mm - 1.5 * size_mm * joint.axis_W, from_mm + 1.5 * size_mm * joint.axis_W, colour);
    addLink(thick_, from_mm, 1.5 * size_mm, to_mm, 0.0, colour);
    thick_.segment(to_mm - 0.8 * size_mm * u, to_mm + 0.8 * size_mm * u, colour);
    thick_.segment(to_mm - 0.8 * size_mm * v, to_mm + 0.8 * size_mm * v, colour);
  }
  if (joint.has_spring) addSpring(joint, size_mm);
}

void RobotPicture::addSpring(const JointFigure& joint, double size_mm) {
  const Vec3 u = joint.axis_W.unitOrthogonal(), v = joint.axis_W.cross(u);
  const Vec3 middle_mm = millimetresOf(joint.from_W);
  std::array<Vec3, kSpringParts + 1> points;
  for (int part = 0; part <= kSpringParts; ++part) {
    const double share = static_cast<double>(part) / kSpringParts;
    if (joint.type == chain::JointType::Revolute) {  // a spiral round the joint
      const double angle_rad = 2.0 * kPi * kTurns * share, radius_mm = (1.4 + 1.2 * share) * size_mm;
      points[static_cast<std::size_t>(part)] =
          middle_mm + radius_mm * (std::cos(angle_rad) * u + std::sin(angle_rad) * v);
    } else {  // a zigzag beside the box
      const double across_mm = (1.6 + (part % 4 < 2 ? 0.0 : 1.0)) * size_mm;
      points[static_cast<std::size_t>(part)] = middle_mm + across_mm * u + (share - 0.5) * 3.0 * size_mm * joint.axis_W;
    }
  }
  thin_.chain(points, theme_.virtual_robot, false);
}

/// The ground, as mechanical drawings mark it: a bar under the first joint, hatched, across the view.
void RobotPicture::addBase(const Vec3& p_mm, double size_mm, const Vec3& right_W) {
  constexpr int kHairs = 5;
  const Vec3 foot_mm = p_mm - 2.6 * size_mm * Vec3::UnitY();
  thick_.segment(p_mm - size_mm * Vec3::UnitY(), foot_mm, theme_.virtual_robot);
  thick_.segment(foot_mm - 2.0 * size_mm * right_W, foot_mm + 2.0 * size_mm * right_W, theme_.virtual_robot);
  for (int hair = 0; hair < kHairs; ++hair) {
    const Vec3 root_mm = foot_mm + (hair - 0.4 * (kHairs - 1)) * size_mm * right_W;
    thin_.segment(root_mm, root_mm - size_mm * (Vec3::UnitY() + 0.7 * right_W), theme_.virtual_robot);
  }
}

void RobotPicture::addTip(const Robot& robot, const Pose& X_WV, const OrbitCamera& camera) {
  const Vec3 tip_mm = millimetresOf(X_WV.translation());
  const Mat3 R_WV = X_WV.linear();
  using manipulator::Orientation;
  if (robot.manipulator.orientation == Orientation::Full) {
    const std::array<QColor, 3> colours{theme_.x_axis, theme_.y_axis, theme_.z_axis};
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      thick_.segment(tip_mm, tip_mm + kFrame_mm * R_WV.col(axis), colours[static_cast<std::size_t>(axis)]);
    }
  } else if (robot.manipulator.orientation != Orientation::None) {
    addArrow(thick_, tip_mm, tip_mm + kZ_mm * R_WV.col(2), camera.back_W(), theme_.virtual_robot);
  } else {
    thick_.circle(tip_mm, camera.right_W(), camera.up_W(), 1.6, theme_.virtual_robot);
  }
  const double beyond_mm = robot.manipulator.orientation == Orientation::None ? 7.0 : kZ_mm + 5.0;
  labels_.push_back(
      {QStringLiteral("V"), tip_mm + beyond_mm * R_WV.col(2), mixed(theme_.virtual_robot, theme_.ink, 0.35), true});
}

void RobotPicture::addDirections(const Robot& robot, const Vec3& tip_mm, const OrbitCamera& camera) {
  const QColor colour = mixed(theme_.virtual_robot, theme_.ink, 0.25);
  const Freedom freedom = freedomOf(robot.manipulator, robot.theta);
  if (freedom.rank == 3) {  // all directions: a ball
    thin_.circle(tip_mm, camera.right_W(), camera.up_W(), 0.5 * kWay_mm, colour);
    return;
  }
  for (int direction = 0; direction < freedom.rank; ++direction) {
    const Vec3 half_mm = kWay_mm * freedom.directions_W.col(direction);
    addArrow(thin_, tip_mm, tip_mm + half_mm, camera.back_W(), colour);
    addArrow(thin_, tip_mm, tip_mm - half_mm, camera.back_W(), colour);
  }
  if (freedom.rank == 2) {
    thin_.circle(tip_mm, freedom.directions_W.col(0), freedom.directions_W.col(1), 0.7 * kWay_mm, colour);
  }
}

/// Dashed, in the force's colour: it belongs to the force, but the arm has no motor for it.
void RobotPicture::addMoment(const Vec3& moment_W, const OrbitCamera& camera) {
  const double size_N_mm = kMillimetrePerMetre * moment_W.norm();
  if (!(size_N_mm >= kMinMoment_N_mm)) return;
  const Vec3 axis = moment_W.normalized();
  const Vec3 u = acrossTowards(axis, Vec3::UnitY()), v = axis.cross(u);
  const Vec3 middle_mm = millimetresOf(p_WT_);
  const double angle_rad = std::min(kArc_rad_per_N_mm * size_N_mm, kLongestArc_rad);
  const auto at = [&](double a_rad) {
    return Vec3(middle_mm + kMomentRadius_mm * (std::cos(a_rad) * u + std::sin(a_rad) * v));
  };
  for (int part = 0; part < kArcParts; ++part) {
    if (part % 4 == 3 && part + 1 < kArcParts) continue;
    thin_.segment(at(angle_rad * part / kArcParts), at(angle_rad * (part + 1) / kArcParts), theme_.force);
  }
  const Vec3 end_mm = at(angle_rad), direction = axis.cross(end_mm - middle_mm).normalized();
  addArrow(thin_, end_mm - 0.1 * direction, end_mm + 0.1 * direction, camera.back_W(), theme_.force);
  labels_.push_back({is_sent_ ? QCoreApplication::translate("SceneView", "moment, sent")
                              : QCoreApplication::translate("SceneView", "moment, not sent"),
                     middle_mm - (kMomentRadius_mm + 8.0) * camera.up_W(), mixed(theme_.force, theme_.ink, 0.45),
                     false});
}

}  // namespace underact::gui
