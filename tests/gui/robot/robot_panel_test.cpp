#include "app/gui/robot/robot_panel.h"

#include <gtest/gtest.h>

#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow robotFeature();
}

namespace underact::gui::test {
namespace {

const scene::VirtualManipulator& robotIn(Desk& desk) {
  return std::get<scene::VirtualManipulator>(desk.scene().constraints.at(0).shape);
}

}  // namespace

TEST(RobotPanel, AJointsLimitIsTypedInDegreesAndIsOneStepBack) {
  Desk desk(robotFeature(), "16_one_joint_robot");
  const auto before = robotIn(desk).joints[0].max;
  ASSERT_TRUE(desk.perform("robot.joint.set", 1, QString("max"), QString("30")));
  EXPECT_NEAR(*robotIn(desk).joints[0].max, 0.5235987756, 1e-9);
  EXPECT_TRUE(desk.undoText().startsWith("joint 1, ")) << desk.undoText().toStdString();
  desk.document().undoStack().undo();
  EXPECT_EQ(robotIn(desk).joints[0].max, before);
}

TEST(RobotPanel, RefusesWhatIsNoNumberInASentence) {
  Desk desk(robotFeature(), "16_one_joint_robot");
  const int steps = desk.document().undoStack().count();
  EXPECT_FALSE(desk.perform("robot.joint.set", 1, QString("max"), QString("wide")));
  EXPECT_FALSE(desk.perform("robot.joint.set", 5, QString("max"), QString("1")));
  EXPECT_EQ(desk.document().undoStack().count(), steps);
  EXPECT_EQ(desk.label("panel.robot.refusal"), QString("There is no such joint."));
}

TEST(RobotPanel, JointsComeMoveAndGo) {
  Desk desk(robotFeature(), "20_scara");
  const std::size_t count = robotIn(desk).joints.size();
  ASSERT_TRUE(desk.perform("robot.joint.add", 1));
  EXPECT_EQ(robotIn(desk).joints.size(), count + 1);
  EXPECT_EQ(desk.undoText(), QString("add a joint"));
  ASSERT_TRUE(desk.perform("robot.joint.remove", 2));
  EXPECT_EQ(robotIn(desk).joints.size(), count);
  EXPECT_FALSE(desk.perform("robot.joint.move", 1, -1)) << "nothing is before the first";
}

TEST(RobotPanel, ARobotThatFollowsTheAngleOfItsOneJointSaysWhatToDoForAnother) {
  Desk desk(robotFeature(), "16_one_joint_robot");
  EXPECT_FALSE(desk.perform("robot.joint.add", 1));
  EXPECT_TRUE(desk.label("panel.robot.refusal").contains("At “Follows”, choose"))
      << desk.label("panel.robot.refusal").toStdString();
  ASSERT_TRUE(desk.perform("robot.orientation.set", QString("axis")));
  EXPECT_TRUE(desk.perform("robot.joint.add", 1));
}

TEST(RobotPanel, WhereNothingOfTheTurnIsFollowedItsStiffnessGoesAndComesBack) {
  Desk desk(robotFeature(), "16_one_joint_robot");
  ASSERT_TRUE(desk.perform("robot.orientation.set", QString("full")));
  ASSERT_TRUE(desk.perform("robot.ko.set", 70.0));
  ASSERT_TRUE(desk.perform("robot.orientation.set", QString("none")));
  EXPECT_EQ(robotIn(desk).ko_N_mm_per_rad, 0.0);
  ASSERT_TRUE(desk.perform("robot.orientation.set", QString("full")));
  EXPECT_GT(robotIn(desk).ko_N_mm_per_rad, 0.0);
}

TEST(RobotPanel, ASceneWithoutOneOffersANewOneWhichIsShown) {
  Desk desk(robotFeature());
  EXPECT_FALSE(desk.perform("robot.remove"));
  ASSERT_TRUE(desk.perform("robot.add"));
  ASSERT_EQ(desk.scene().constraints.size(), 2U);
  EXPECT_EQ(desk.undoText(), QString("new robot"));
  ASSERT_TRUE(desk.perform("robot.remove"));
  EXPECT_EQ(desk.scene().constraints.size(), 1U);
}

}  // namespace underact::gui::test
