#include <QComboBox>
#include <QSlider>
#include <cmath>

#include "tests/stories/picture_difference.h"
#include "tests/stories/robot_desk.h"

namespace underact::gui::test {

TEST(RobotStory, AJointThatIsAddedIsFeltDrawnAndTakenBack) {
  Robot story("16_one_joint_robot");
  ASSERT_TRUE(story.perform("robot.orientation.set", "none"));
  story.hold({0.034, 0.012, 0.0});
  ASSERT_GT(story.wanted_N().norm(), 0.5);  // the rim of 50 mm is far
  const QImage before = story.view().picture();
  story.clickThere("panel.robot.joint.add");
  EXPECT_EQ(story.robot().joints.size(), 2u);
  EXPECT_EQ(story.robot().joints[1].point_mm, Vec3(25, 0, 0));  // halfway to the tip
  EXPECT_EQ(story.joints()->rowCount(), 2);
  story.run(3000);
  EXPECT_EQ(story.now().joints, 2u);
  EXPECT_LT(story.wanted_N().norm(), 0.03);  // two links reach every place of the disc
  story.settle();
  EXPECT_GT(worstBlockDifference(before, story.view().picture()), 2.0 * kTolerance);
  story.key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(story.robot().joints.size(), 1u);
  EXPECT_EQ(story.joints()->rowCount(), 1);
  story.run(3000);
  EXPECT_GT(story.wanted_N().norm(), 0.5);
}

TEST(RobotStory, TheTurningStiffnessChangesTheForceOnATurnedStylus) {
  Robot story("16_one_joint_robot");
  story.hold({0.050, 0.0, 0.0}, Vec3(1.0, 0.35, 0.0));
  const double before_N = story.wanted_N().norm();
  ASSERT_GT(before_N, 0.1);
  story.find<QSlider>("panel.robot.ko.slider")->setFocus();
  story.key(Qt::Key_PageUp);
  EXPECT_DOUBLE_EQ(story.robot().ko_N_mm_per_rad, 275.0);
  story.run(100);  // five time constants of the fade; the stylus hardly moves
  EXPECT_NEAR(story.wanted_N().norm() / before_N, 275.0 / 250.0, 0.04);
  story.type(story.find("panel.robot.ko.number"), "0");
  story.run(3000);
  EXPECT_LT(story.wanted_N().norm(), 0.2 * before_N);
  QTest::mouseDClick(story.find("panel.robot.ko.slider"), Qt::LeftButton);
  EXPECT_DOUBLE_EQ(story.robot().ko_N_mm_per_rad, 250.0);  // the scene's own
}

TEST(RobotStory, TheMethodOfTheSolverChangesNothingThatIsFelt) {
  Robot story("18_sphere_of_two_joints");
  story.hold({0.012, 0.018, 0.034});
  story.settle();
  EXPECT_EQ(story.readout("Solved by"), "closed form");
  const Vec3 before_N = story.wanted_N();
  ASSERT_GT(before_N.norm(), 0.05);
  story.find<QComboBox>("panel.robot.method")->setCurrentIndex(2);
  EXPECT_EQ(story.robot().solver.method, scene::SolverMethod::Iterative);
  story.run(1);
  EXPECT_NEAR((story.wanted_N() - before_N).norm(), 0.0, 2e-3);  // the hand moves a little from tick to tick
  story.run(300);
  story.settle();
  EXPECT_TRUE(story.readout("Solved by").startsWith("iteration")) << story.readout("Solved by").toStdString();
  EXPECT_NEAR((story.wanted_N() - before_N).norm(), 0.0, 2e-3);
}

TEST(RobotStory, TheThesissLawIsTakenForOneJointAndRefusedForTwoInAWord) {
  {
    Robot one("16_one_joint_robot");
    EXPECT_TRUE(one.perform("robot.law.set", "thesis-5.2"));
    EXPECT_EQ(one.robot().force_law, manipulator::ForceLaw::Thesis52);
  }
  Robot two("18_sphere_of_two_joints");
  two.find<QComboBox>("panel.robot.law")->setCurrentIndex(1);
  EXPECT_TRUE(two.refusal().contains("just one joint, a revolute one")) << two.refusal().toStdString();
  EXPECT_EQ(two.find<QComboBox>("panel.robot.law")->currentIndex(), 0);
  EXPECT_EQ(two.window().document().undoStack().count(), 0);
  EXPECT_TRUE(two.perform("robot.orientation.set", "none"));
  EXPECT_EQ(two.refusal(), QString());  // the sentence goes with the next edit that is taken
  EXPECT_EQ(two.robot().ko_N_mm_per_rad, 0.0);
  EXPECT_FALSE(two.find("panel.robot.ko")->isEnabled());
  EXPECT_TRUE(two.perform("robot.orientation.set", "axis"));
  EXPECT_EQ(two.robot().ko_N_mm_per_rad, 250.0);  // the scene's own again
}

TEST(RobotStory, EveryCellIsTypedAndOneStepBackEach) {
  Robot story("20_scara");
  const int steps = story.window().document().undoStack().count();
  story.typeCell(story.joints(), 0, Robot::kPointX, "-55.5");
  EXPECT_EQ(story.robot().joints[0].point_mm.x(), -55.5);
  EXPECT_EQ(story.joints()->item(0, Robot::kPointX)->text(), QString(QChar(0x2212)) + "55.5");
  story.typeCell(story.joints(), 0, Robot::kMax, "90");
  EXPECT_NEAR(*story.robot().joints[0].max, std::acos(0.0), 1e-12);
  story.typeCell(story.joints(), 0, Robot::kSpring, "40");
  EXPECT_EQ(story.robot().joints[0].stiffness, 40.0);
  EXPECT_EQ(story.window().document().undoStack().count(), steps + 3);
  for (int step = 0; step < 3; ++step) story.perform("edit.undo");
  EXPECT_EQ(story.robot().joints[0].max, 1.2);
  EXPECT_EQ(story.robot().joints[0].stiffness, 0.0);
  EXPECT_FALSE(story.window().isWindowModified());
}

TEST(RobotStory, AnImpossibleEditIsRefusedAndTheOldNumberIsBack) {
  Robot story("16_one_joint_robot");
  story.typeCell(story.joints(), 0, Robot::kAxisZ, "0");
  EXPECT_TRUE(story.refusal().contains("must not be [0, 0, 0]")) << story.refusal().toStdString();
  EXPECT_EQ(story.joints()->item(0, Robot::kAxisZ)->text(), "1.000");
  story.typeCell(story.joints(), 0, Robot::kPointX, "1e");
  EXPECT_TRUE(story.refusal().contains("not a number")) << story.refusal().toStdString();
  EXPECT_EQ(story.joints()->item(0, Robot::kPointX)->text(), "0.0");
  story.clickThere("panel.robot.joint.add");
  EXPECT_TRUE(story.refusal().contains("about its one joint")) << story.refusal().toStdString();
  EXPECT_EQ(story.robot().joints.size(), 1u);
  EXPECT_FALSE(story.find("panel.robot.joint.remove")->isEnabled());  // one stays
  EXPECT_FALSE(story.perform("robot.joint.remove", 1));
  EXPECT_EQ(story.window().document().undoStack().count(), 0);
  story.run(10);
  EXPECT_EQ(story.snapshot().report.held[0].robot.joints, 1u);
}

TEST(RobotStory, JointsAreMovedAndTakenAwayAndEightIsAllThereAre) {
  Robot story("20_scara");
  const std::vector<scene::Joint> joints = story.robot().joints;
  story.joints()->setCurrentCell(2, 0);
  story.clickThere("panel.robot.joint.up");
  EXPECT_EQ(story.robot().joints[1], joints[2]);
  EXPECT_EQ(story.joints()->currentRow(), 1);
  story.clickThere("panel.robot.joint.down");
  EXPECT_EQ(story.robot().joints, joints);
  while (story.robot().joints.size() < manipulator::kMaxJoints) ASSERT_TRUE(story.perform("robot.joint.add", 1));
  EXPECT_FALSE(story.find("panel.robot.joint.add")->isEnabled());
  EXPECT_FALSE(story.perform("robot.joint.add", 1));
  EXPECT_TRUE(story.refusal().contains("8")) << story.refusal().toStdString();
  story.joints()->setCurrentCell(0, 0);
  story.clickThere("panel.robot.joint.remove");
  EXPECT_EQ(story.robot().joints.size(), manipulator::kMaxJoints - 1);
  story.hold({0.012, 0.018, 0.034});
  EXPECT_EQ(story.snapshot().mode, servo::Mode::Running);
}

TEST(RobotStory, TheTipAtHomeIsTypedAsPlaceAndAngles) {
  Robot story("18_sphere_of_two_joints");
  auto* home = story.find<QTableWidget>("panel.robot.home");
  story.typeCell(home, 0, 2, "55");
  EXPECT_EQ(story.robot().X_WV_home(2, 3), 55.0);
  story.typeCell(home, 1, 1, "90");
  EXPECT_EQ((Vec3(story.robot().X_WV_home.topLeftCorner<3, 3>().col(2))), Vec3::UnitX());
  story.typeCell(home, 1, 2, "30");  // at this turn x and z are one: what was typed stays in the cell
  EXPECT_EQ(home->item(1, 2)->text(), "30.0");
  EXPECT_EQ(home->item(1, 0)->text(), "0.0");
  story.hold({0.0, 0.0, 0.050});
  EXPECT_NEAR(story.snapshot().report.held[0].p_WP.norm(), 0.055, 1e-4);
}

TEST(RobotStory, ANewRobotStandsBesideWhatThereWasAndGoesAgain) {
  Robot story("02_sphere");
  EXPECT_TRUE(story.find("panel.robot.none")->isVisible());
  EXPECT_FALSE(story.find("panel.robot.joints")->isVisible());
  EXPECT_FALSE(story.find("panel.robot.remove")->isEnabled());
  story.clickThere("panel.robot.add");
  ASSERT_EQ(story.host().scene().constraints.size(), 2u);
  EXPECT_EQ(story.robot(1).joints.size(), 1u);
  EXPECT_FALSE(story.find("panel.robot.none")->isVisible());
  EXPECT_EQ(story.view().robotsDrawn(), 1u);
  EXPECT_TRUE(story.find("panel.feel.constraint")->isVisible());  // its gains can be chosen
  EXPECT_FALSE(story.find("panel.robot.constraint")->isVisible());
  story.clickThere("panel.robot.add");
  EXPECT_TRUE(story.find("panel.robot.constraint")->isVisible());
  EXPECT_EQ(story.find<QComboBox>("panel.robot.constraint")->currentText(), "robot 2");
  EXPECT_TRUE(story.perform("robot.home.set", "place", "x", "25"));
  EXPECT_EQ(story.robot(2).X_WV_home(0, 3), 25.0);
  EXPECT_EQ(story.robot(1).X_WV_home(0, 3), 40.0);
  EXPECT_TRUE(story.perform("robot.choose", 1));
  story.clickThere("panel.robot.remove");
  ASSERT_EQ(story.host().scene().constraints.size(), 2u);
  EXPECT_EQ(story.robot(1).X_WV_home(0, 3), 25.0);
  story.hold({0.012, 0.018, 0.034});
  EXPECT_EQ(story.snapshot().mode, servo::Mode::Running);
  for (int step = 0; step < 4; ++step) story.perform("edit.undo");
  EXPECT_EQ(story.host().scene().constraints.size(), 1u);
  EXPECT_TRUE(story.find("panel.robot.none")->isVisible());
  EXPECT_FALSE(story.find("panel.feel.constraint")->isVisible());
  EXPECT_FALSE(story.window().isWindowModified());
  EXPECT_FALSE(story.perform("robot.remove"));
}

TEST(RobotStory, AnEditedRobotIsSavedAndOpensAsItWas) {
  const QString path = temporaryFile("edited_robot.json");
  std::vector<scene::Joint> joints;
  {
    Robot story("18_sphere_of_two_joints");
    EXPECT_TRUE(story.perform("robot.joint.set", 2, "max", "60"));
    EXPECT_TRUE(story.perform("robot.joint.set", 1, "stiffness", "12.5"));
    EXPECT_TRUE(story.perform("robot.solver.set", "max_steps", 7));
    EXPECT_TRUE(story.perform("robot.solver.set", "tolerance", "1e-8"));
    EXPECT_FALSE(story.perform("robot.solver.set", "tolerance", "2"));
    EXPECT_TRUE(story.perform("robot.ko.set", 123.0));
    EXPECT_TRUE(story.perform("scene.save_as", path));
    joints = story.robot().joints;
  }
  Robot story(path);
  EXPECT_EQ(story.robot().joints, joints);
  EXPECT_EQ(story.robot().solver.max_steps, 7);
  EXPECT_EQ(story.robot().solver.tolerance, 1e-8);
  EXPECT_EQ(story.robot().ko_N_mm_per_rad, 123.0);
  EXPECT_FALSE(story.window().isWindowModified());
}

TEST(RobotStory, TheReadoutSaysWhatTheSolverFoundAndWhichJointStandsAtALimit) {
  Robot story("16_one_joint_robot");
  story.hold({0.050, 0.0, 0.0}, Vec3(1.0, 0.35, 0.0));
  story.settle();
  EXPECT_NEAR(story.readout("Moment, not sent").split(' ').first().toDouble(), 1e3 * story.now().moment_W.norm(), 0.06);
  EXPECT_GT(story.now().moment_W.norm(), 0.01);
  EXPECT_TRUE(story.readout("Energy").endsWith(" mJ"));
  EXPECT_EQ(story.readout("Target"), "at the end effector");
  EXPECT_TRUE(story.perform("robot.joint.set", 1, "min", "-90"));
  EXPECT_TRUE(story.perform("robot.joint.set", 1, "max", "-3"));
  story.run(1000);
  story.settle();
  EXPECT_TRUE(story.readout("Joint q1").startsWith("at maximum")) << story.readout("Joint q1").toStdString();
  EXPECT_NEAR(story.now().theta[0], -3.0 * std::acos(-1.0) / 180.0, 1e-6);
}

}  // namespace underact::gui::test
