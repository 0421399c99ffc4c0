#include <gtest/gtest.h>

#include <cmath>

#include "app/gui/view/robot_figure.h"
#include "core/base/units.h"
#include "core/scene/compile.h"
#include "tests/gui/example.h"

namespace underact::gui {
namespace {

using chain::JointType;
using test::count;
using test::isPurple;
using test::Shown;
using test::turning;

scene::Joint sliding(const Vec3& axis) {
  scene::Joint joint;
  joint.type = JointType::Prismatic;
  joint.axis = axis;
  return joint;
}

scene::VirtualManipulator robotOf(std::vector<scene::Joint> joints, const Vec3& tip_mm) {
  scene::VirtualManipulator robot;
  robot.joints = std::move(joints);
  robot.X_WV_home.topRightCorner<3, 1>() = tip_mm;
  return robot;
}

/// A scene that can be compiled.
scene::Description sceneOf(const scene::VirtualManipulator& robot) {
  scene::Description scene = test::sceneOf(robot);
  scene.title = "one";
  return scene;
}

manipulator::Manipulator made(const scene::VirtualManipulator& robot) {
  const Result<tick::TickProgram> program = scene::compile(sceneOf(robot));
  EXPECT_TRUE(program) << (program ? "" : program.problems().front().sentence);
  return std::get<manipulator::Manipulator>(program.value().entries.front().constraint.goal);
}

const scene::VirtualManipulator kOneJoint = robotOf({turning(Vec3::UnitZ(), Vec3::Zero())}, {40, 0, 0});
const scene::VirtualManipulator kTwoLinks =
    robotOf({turning(Vec3::UnitZ(), Vec3::Zero()), turning(Vec3::UnitZ(), {30, 0, 0})}, {60, 0, 0});

servo::Snapshot snapshotOf(const scene::VirtualManipulator& robot, const manipulator::Values& theta) {
  servo::Snapshot snapshot = test::snapshotAt({0.06, -0.05, 0.0}, {0.06, -0.05, 0.0}, Vec3::Zero());
  snapshot.report.held[0].robot.joints = robot.joints.size();
  snapshot.report.held[0].robot.theta = theta;
  return snapshot;
}

/// The view with robots alone.
struct RobotShown : Shown {
  explicit RobotShown(const scene::VirtualManipulator& robot) : Shown(sceneOf(robot)) {
    Layers layers;
    layers.workspace = layers.triads = layers.arm = layers.target = layers.force = false;
    view.setLayers(layers);
    wheel({400.0, 300.0}, -1);  // it turns out of the picture that it fills
  }
  int at(const Vec3& p_mm, double around = 3.0) {
    return count(view.picture(), view.screenOf(kMetrePerMillimetre * p_mm), around, isPurple);
  }
};

}  // namespace

TEST(RobotFigure, JointsStandAtTheirPointsAndTurnWithTheLinksBeforeThem) {
  const manipulator::Manipulator robot = made(kTwoLinks);
  const manipulator::Values theta{0.5 * kPi, 0.5 * kPi};
  const RobotFigure figure = figureOf(robot, theta);
  ASSERT_EQ(figure.joints.size(), 2u);
  EXPECT_TRUE(figure.joints[0].to_W.isApprox(Vec3::Zero()));
  EXPECT_NEAR((figure.joints[1].to_W - Vec3(0, 0.03, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((figure.X_WV.translation() - Vec3(-0.03, 0.03, 0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(figure.joints[1].at_same_place, 0);
}

TEST(RobotFigure, ASlidingJointStandsBetweenItsNeighboursAndItsRodSlides) {
  const manipulator::Manipulator robot =
      made(robotOf({turning(Vec3::UnitY(), Vec3::Zero()), sliding(Vec3::UnitY())}, {30, -20, 0}));
  const RobotFigure figure = figureOf(robot, manipulator::Values{0.0, 0.01});
  EXPECT_NEAR((figure.joints[1].from_W - Vec3(0.03, 0, 0)).norm(), 0.0, 1e-12);  // over the tip, beside the first
  EXPECT_NEAR((figure.joints[1].to_W - Vec3(0.03, 0.01, 0)).norm(), 0.0, 1e-12);
}

TEST(RobotFigure, AxesThatCrossAreCountedSoThatTheyAreDrawnApart) {
  const manipulator::Manipulator robot =
      made(robotOf({turning(Vec3::UnitY(), Vec3::Zero()), turning(Vec3::UnitX(), Vec3::Zero()),
                    turning(Vec3::UnitZ(), Vec3::Zero())},
                   {0, 0, 40}));
  const RobotFigure figure = figureOf(robot, manipulator::Values{});
  EXPECT_EQ(figure.joints[0].at_same_place, 0);
  EXPECT_EQ(figure.joints[1].at_same_place, 1);
  EXPECT_EQ(figure.joints[2].at_same_place, 2);
}

TEST(RobotFreedom, OneJointGoesAlongItsTangentAlone) {
  const Freedom freedom = freedomOf(made(kOneJoint), manipulator::Values{0.3});
  ASSERT_EQ(freedom.rank, 1);
  const Vec3 tangent(-std::sin(0.3), std::cos(0.3), 0.0);
  EXPECT_NEAR(std::abs(freedom.directions_W.col(0).dot(tangent)), 1.0, 1e-12);
  EXPECT_NEAR(freedom.reach_m_per_rad[0], 0.04, 1e-12);
}

TEST(RobotFreedom, TwoCrossingJointsGoInTheTangentPlaneAndAtThePoleOneWayIsLost) {
  const manipulator::Manipulator robot =
      made(robotOf({turning(Vec3::UnitY(), Vec3::Zero()), turning(Vec3::UnitX(), Vec3::Zero())}, {0, 0, 40}));
  const Freedom freedom = freedomOf(robot, manipulator::Values{0.4, 0.2});
  ASSERT_EQ(freedom.rank, 2);
  const Vec3 radius = figureOf(robot, manipulator::Values{0.4, 0.2}).X_WV.translation();
  EXPECT_NEAR(freedom.directions_W.col(0).dot(radius), 0.0, 1e-12);
  EXPECT_NEAR(freedom.directions_W.col(1).dot(radius), 0.0, 1e-12);
  EXPECT_EQ(freedomOf(robot, manipulator::Values{0.4, 0.5 * kPi}).rank, 1);  // the first axis goes through the tip
}

TEST(RobotFreedom, AStretchedElbowLosesAWayAndAStraightLineKeepsItsOwn) {
  EXPECT_EQ(freedomOf(made(kTwoLinks), manipulator::Values{0.2, 1.0}).rank, 2);
  EXPECT_EQ(freedomOf(made(kTwoLinks), manipulator::Values{0.2, 0.0}).rank, 1);
  EXPECT_EQ(freedomOf(made(kTwoLinks), manipulator::Values{0.2, 0.9 * kLostShare}).rank, 1);  // as good as stretched
  const Freedom line = freedomOf(made(robotOf({sliding({0, 3, 4})}, {0, 0, 0})), manipulator::Values{0.02});
  ASSERT_EQ(line.rank, 1);
  EXPECT_NEAR(std::abs(line.directions_W.col(0).dot(Vec3(0, 0.6, 0.8))), 1.0, 1e-12);
  EXPECT_EQ(freedomOf(made(robotOf({turning(Vec3::UnitX(), Vec3::Zero())}, {30, 0, 0})), manipulator::Values{}).rank,
            0);  // a tip on its own axis goes nowhere
}

TEST(RobotPicture, TheLinkIsPurpleWhereTheJointsOfTheTickPutItAndNowhereWithoutItsLayer) {
  RobotShown shown(kOneJoint);
  shown.view.present(snapshotOf(kOneJoint, {}));
  EXPECT_EQ(shown.view.robotsDrawn(), 1u);
  EXPECT_GT(shown.at({20, 0, 0}), 5);
  EXPECT_EQ(shown.at({0, 20, 0}), 0);
  shown.view.present(snapshotOf(kOneJoint, {0.5 * kPi}));
  EXPECT_EQ(shown.at({20, 0, 0}), 0);
  EXPECT_GT(shown.at({0, 20, 0}), 5);
  Layers layers = shown.view.layers();
  layers.robot = false;
  shown.view.setLayers(layers);
  EXPECT_EQ(shown.view.robotsDrawn(), 0u);
  EXPECT_EQ(shown.at({0, 20, 0}, 60.0), 0);
  EXPECT_EQ(shown.view.glErrors(), 0);
}

TEST(RobotPicture, JointsAreHollow) {
  RobotShown shown(kOneJoint);
  shown.view.present(snapshotOf(kOneJoint, {}));
  EXPECT_EQ(shown.at(Vec3::Zero(), 2.0), 0);  // seen along the axis: a ring with nothing in it
  EXPECT_GT(shown.at(Vec3::Zero(), 30.0), 20);
}

TEST(RobotPicture, LinksAreTranslucentSolidsAboutTheLines) {
  RobotShown shown(kOneJoint);
  shown.view.present(snapshotOf(kOneJoint, {}));
  const auto pale = [&](const Vec3& p_mm) {
    return count(shown.view.picture(), shown.view.screenOf(kMetrePerMillimetre * p_mm), 0.5, [](const QColor& c) {
      return c.saturation() > 12 && c.saturation() < 60 && c.hue() > 300 && c.hue() < 345;
    });
  };
  EXPECT_GT(pale({20, 1.0, 0}), 0);
  EXPECT_EQ(pale({20, 4.0, 0}), 0);
  shown.view.present(snapshotOf(kOneJoint, {0.5 * kPi}));
  EXPECT_EQ(pale({20, 1.0, 0}), 0);
  EXPECT_GT(pale({1.0, 20, 0}), 0);
}

TEST(RobotPicture, AnEditIsSeenAndJointsThatTheServoHasNotTakenUpAreNotMixedUp) {
  RobotShown shown(kOneJoint);
  shown.view.present(snapshotOf(kOneJoint, {0.5 * kPi}));
  shown.view.followEdit(sceneOf(kTwoLinks));
  shown.view.present(snapshotOf(kOneJoint, {0.5 * kPi}));  // a tick from before the edit
  EXPECT_GT(shown.at({45, 0, 0}), 5);                      // at home
  shown.view.present(snapshotOf(kTwoLinks, {0.0, 0.5 * kPi}));
  EXPECT_EQ(shown.at({45, 0, 0}), 0);
  EXPECT_GT(shown.at({30, 15, 0}), 5);
}

TEST(RobotPicture, TheMomentIsAnArcAsLongAsItIsLarge) {
  RobotShown shown(kOneJoint);
  const auto orange = [&](double moment_N_m) {
    servo::Snapshot snapshot = snapshotOf(kOneJoint, {});
    snapshot.report.held[0].robot.moment_W = Vec3(0, 0, moment_N_m);
    shown.view.present(snapshot);
    const QPointF tip = shown.view.screenOf(snapshot.report.p_WT);
    return count(shown.view.picture(), tip, 120.0,
                 [](const QColor& c) { return c.saturation() > 60 && c.hue() > 30 && c.hue() < 50; });
  };
  const int none = orange(0.001), some = orange(0.060), more = orange(0.180);
  EXPECT_EQ(none, 0);
  EXPECT_GT(some, 30);
  EXPECT_GT(more, 1.5 * some);  // the head and the words are as many for both
}

}  // namespace underact::gui
