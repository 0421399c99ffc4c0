// Scenes for arms that are not of the Omni's form, in the window.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QTableWidget>

#include "core/arm/arm_text.h"
#include "core/arm/forward.h"
#include "core/arm/mechanism.h"
#include "core/arm/model.h"
#include "core/base/units.h"
#include "core/scene/scene_arm.h"
#include "tests/stories/picture_difference.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

QStringList shippedForOtherArms() {
  QStringList names;
  for (const QString& name : QDir(QFileInfo(shippedScene("02_sphere")).path()).entryList({"3*.json"}))
    names << QString(name).remove(".json");
  return names;
}

}  // namespace

TEST(OtherArmsStory, EachSceneOpensFreeOfFaultsWithItsArmAtRest) {
  Story story("02_sphere");
  const QStringList names = shippedForOtherArms();
  ASSERT_EQ(names.size(), 10);
  for (const QString& name : names) {
    ASSERT_TRUE(story.perform("scene.open", shippedScene(name))) << name.toStdString();
    story.perform("session.start");
    story.run(600);
    const servo::Snapshot snapshot = story.snapshot();
    EXPECT_EQ(snapshot.report.fault.kind, FaultKind::None) << name.toStdString();
    EXPECT_EQ(snapshot.mode, servo::Mode::Running);
    const arm::Preset& preset = scene::armOf(story.window().document().scene());
    const Vec3 p_WRest = arm::tipPosition(preset.geometry, preset.geometry.mechanism->rest);
    EXPECT_LT((snapshot.report.p_WT - p_WRest).norm(), 0.02) << name.toStdString();
  }
}

TEST(OtherArmsStory, ATableIsFeltByAnArmThatIsDraggedOntoIt) {
  Story story("30_ur5e_table");
  story.perform("session.start");
  story.run(600);
  EXPECT_LT(story.force_N(), 0.01);
  device::SimulatedArm& arm = story.arm();
  sim::HandSetpoint wish = arm.setpoint();
  wish.p_WT += Vec3(0.0, 0.0, -0.03);
  arm.setSetpoint(wish);
  story.run(3000);
  EXPECT_GT(story.force_N(), 1.0);
  EXPECT_GT(story.snapshot().report.force.f_T_W().z(), 1.0);
}

TEST(OtherArmsStory, TheSceneGetsAnotherArmAndItsOwnOneBack) {
  Story story("02_sphere");
  story.perform("dock.arm", true);
  story.run(100);
  auto* const arms = story.find<QComboBox>("panel.arm.choose");
  EXPECT_EQ(arms->currentData().toString(), "omni-thesis");
  EXPECT_TRUE(story.perform("scene.arm", "cobra-600"));
  story.run(600);
  EXPECT_EQ(arms->currentData().toString(), "cobra-600");
  EXPECT_EQ(story.snapshot().report.fault.kind, FaultKind::None);
  EXPECT_TRUE(story.find<QLabel>("panel.arm.value.1")->text().contains("mm")) << "its third joint slides";
  EXPECT_TRUE(story.perform("edit.undo"));
  story.run(600);
  EXPECT_EQ(arms->currentData().toString(), "omni-thesis");
  EXPECT_EQ(story.snapshot().report.fault.kind, FaultKind::None);
}

TEST(OtherArmsStory, AFileThatIsDroppedBecomesTheArmAndABadOneIsSaid) {
  Story story("02_sphere");
  const QString urdf = temporaryFile(
      "mine.urdf", QByteArray::fromStdString(arm::textOf(*arm::findModel("ur5e"), arm::ArmForm::Urdf).value()));
  EXPECT_TRUE(story.perform("scene.open", urdf)) << "as a drop does";
  story.run(300);
  auto* const arms = story.find<QComboBox>("panel.arm.choose");
  EXPECT_TRUE(arms->currentText().contains("mine.urdf"));
  const QString bad = temporaryFile("bad.json", R"({"underact_arm": 1, "name": "x"})");
  EXPECT_FALSE(story.perform("scene.open", bad));
  EXPECT_NE(story.find("dialog.scene_arm_problems"), nullptr);
  EXPECT_TRUE(arms->currentText().contains("mine.urdf")) << "the last one stays";
}

TEST(OtherArmsStory, TheKinematicsPanelHasAsManyRowsAsTheArmHasJoints) {
  Story story("32_scara_hole");
  EXPECT_TRUE(story.perform("dock.kinematics", true));
  story.settle();
  story.run(500);
  EXPECT_TRUE(story.find("panel.kinematics.joint.4")->isVisible());
  EXPECT_FALSE(story.find("panel.kinematics.joint.5")->isVisible());
  EXPECT_EQ(story.find<QLabel>("panel.kinematics.solutions.status")->text().left(11), "2 solutions");
  EXPECT_EQ(story.find<QLabel>("panel.kinematics.dh.3.4")->text(), "100.0") << "d of the slide";
  story.perform("session.stop");
  story.run(200);
  EXPECT_TRUE(story.perform("joint.set", 3, 40.0));
  story.run(3000);
  EXPECT_NEAR(story.snapshot().report.sample.q_rad[2], 0.040, 1e-3);
}

TEST(OtherArmsStory, ASeventhJointIsShownAndMovedByItsSlider) {
  Story story("38_panda_wall");
  EXPECT_TRUE(story.perform("view.kinematics"));
  story.settle();
  story.run(500);
  EXPECT_TRUE(story.find("panel.kinematics.joint.7")->isVisible());
  EXPECT_FALSE(story.find("panel.kinematics.joint.8")->isVisible());
  EXPECT_EQ(story.find<QLabel>("panel.kinematics.dh.7.3")->text(), "45.0") << "theta with the joint at rest";
  story.perform("session.stop");
  story.run(200);
  EXPECT_TRUE(story.perform("joint.set", 7, -20.0));
  EXPECT_FALSE(story.perform("joint.set", 8, 5.0));
  story.run(4000);
  EXPECT_NEAR(story.snapshot().report.sample.q_rad[6], -20.0 * kRadPerDegree, 0.01);
  EXPECT_EQ(story.snapshot().report.joints, 7);
}

TEST(OtherArmsStory, EightGhostsOfAUr5eAreListedSelectedAndSeen) {
  Story story("30_ur5e_table");
  story.perform("view.theme.light");
  story.perform("session.stop");
  EXPECT_TRUE(story.perform("dock.kinematics", true));
  EXPECT_TRUE(story.perform("layer.ghosts", true));
  story.run(500);
  story.settle();
  EXPECT_EQ(story.view().solutionsDrawn(), 8U);
  EXPECT_EQ(story.find<QLabel>("panel.kinematics.solutions.status")->text(), "8 solutions, 8 within the joint limits.");
  auto* const table = story.find<QTableWidget>("panel.kinematics.solutions");
  EXPECT_FALSE(table->isRowHidden(7));
  EXPECT_TRUE(table->isRowHidden(8));
  int now = 0;
  for (int row = 0; row < 8; ++row) now += table->item(row, 5)->text().contains("now") ? 1 : 0;
  EXPECT_EQ(now, 1) << "the arm itself";
  EXPECT_FALSE(story.perform("solution.show", 9));
  ASSERT_TRUE(story.perform("solution.show", 6));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !story.view().solutionMoving(); }));
  const arm::JointAngles chosen = *story.view().chosenSolution_rad();
  const arm::Geometry& geometry = arm::findPreset("ur5e")->geometry;
  EXPECT_LT((arm::tipPosition(geometry, chosen) - story.snapshot().report.p_WT).norm(), 1e-9);
  const QString angles = story.find<QLabel>("panel.kinematics.solutions.angles")->text();
  EXPECT_TRUE(angles.contains("shoulder") && angles.contains("wrist")) << angles.toStdString();
  story.view().clearFocus();
  story.settle(300);
  EXPECT_LT(story.imageDifference("ur5e_ghosts"), kTolerance);
  EXPECT_TRUE(story.perform("scene.open", shippedScene("02_sphere")));
  EXPECT_FALSE(story.view().chosenSolution_rad().has_value()) << "another arm has other solutions";
}

TEST(OtherArmsStory, OfAnArmWithJointsToSpareThePanelSaysWhatItsSolutionsAre) {
  Story story("38_panda_wall");
  EXPECT_TRUE(story.perform("view.kinematics"));
  story.settle();
  story.run(500);
  const QString status = story.find<QLabel>("panel.kinematics.solutions.status")->text();
  EXPECT_TRUE(status.contains("infinitely many") && status.contains("16 starts")) << status.toStdString();
  EXPECT_GT(story.view().solutionsDrawn(), 2U);
  ASSERT_TRUE(story.perform("solution.show", 2));
  EXPECT_TRUE(story.find<QLabel>("panel.kinematics.solutions.angles")->text().contains("null space"));
}

TEST(OtherArmsStory, AMomentIsSentByAnArmThatRendersItAndThePanelSaysSo) {
  Story story("39_iiwa_pose");
  EXPECT_TRUE(story.perform("dock.robot", true));
  story.perform("session.start");
  story.run(600);
  device::SimulatedArm& arm = story.arm();
  sim::HandSetpoint wish = arm.setpoint();
  wish.turns = true;
  wish.R_WT = Eigen::AngleAxisd(0.2, Vec3::UnitX()) *
              arm::tipPose(arm::findPreset("iiwa7")->geometry, story.snapshot().report.sample.q_rad).linear();
  arm.setSetpoint(wish);
  story.run(3000);
  EXPECT_GT(story.snapshot().report.force.m_T_W().norm(), 0.01);
  EXPECT_LE(story.snapshot().report.force.m_T_W().norm(), 0.5 * (1.0 + 1e-12));
  bool says = false;
  for (const QLabel* label : story.window().findChildren<QLabel*>()) says |= label->text() == "Moment, sent";
  EXPECT_TRUE(says);
}

}  // namespace underact::gui::test
