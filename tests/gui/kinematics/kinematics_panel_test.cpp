#include "app/gui/kinematics/kinematics_panel.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>

#include "app/gui/kinematics/distance_bar.h"
#include "app/gui/kinematics/sections.h"
#include "core/arm/forward.h"
#include "core/base/units.h"
#include "core/scene/scene_arm.h"
#include "device/simulated_arm.h"
#include "tests/gui/desk.h"
#include "tests/gui/example.h"
#include "tests/support/arm_files.h"

namespace underact::gui {
FeatureRow kinematicsFeature();
}

namespace underact::gui::test {

TEST(DistanceBar, SaysNearBelowItsMarkAndNotAbove) {
  DistanceBar bar("bar", "elbow", "tip", {.near_below = 5.0, .farthest = 100.0, .decimals = 1, .unit = " mm"});
  bar.present(5.1);
  EXPECT_EQ(bar.findChild<QLabel*>("bar.value")->text(), QString("5.1 mm"));
  EXPECT_EQ(bar.findChild<QLabel*>("bar.word")->text(), QString());
  bar.present(4.9);
  EXPECT_TRUE(bar.isNear());
  EXPECT_EQ(bar.findChild<QLabel*>("bar.word")->text(), QString("near"));
}

TEST(KinematicsPanel, AJointIsSetWhileTheServoIsStoppedAndNotWhileItRuns) {
  Desk desk(kinematicsFeature());
  ASSERT_TRUE(desk.perform("joint.set", 1, 20.0));
  arm::JointAngles q_rad = desk.host().snapshot().report.sample.q_rad;
  q_rad[0] = 20.0 * kRadPerDegree;
  EXPECT_NEAR((desk.arm().setpoint().p_WT - arm::tipPose(preset().geometry, q_rad).translation()).norm(), 0.0, 1e-9);
  EXPECT_FALSE(desk.perform("joint.set", 7, 20.0)) << "there are six";
  desk.perform("session.start");
  desk.run(300);
  const Vec3 before = desk.arm().setpoint().p_WT;
  EXPECT_FALSE(desk.perform("joint.set", 1, -20.0));
  EXPECT_EQ(desk.arm().setpoint().p_WT, before);
}

TEST(KinematicsPanel, AnArmFromAFileIsThatOfTheServoOfTheSimulatedArmAndOfThePanel) {
  Desk desk(kinematicsFeature());
  desk.run(100);
  const std::string arm =
      desk.fileOf("mine.json", QByteArray::fromStdString(underact::test::armFile("160"))).toStdString();
  const QString own = desk.fileOf("own.json", QByteArray::fromStdString(R"({"underact_scene": 1, "title": "My own arm",
    "arm": ")" + arm + R"(", "constraints": [{"type": "point", "position_mm": [0, 0, 300]}]})"));
  desk.open(own);
  const arm::Geometry& geometry = scene::armOf(desk.scene()).geometry;
  EXPECT_EQ(geometry.upper_m, 0.16);
  const Vec3 p_WT(0.02, 0.03, 0.04);
  desk.handTo(p_WT);
  const servo::Snapshot now = desk.host().snapshot();
  EXPECT_LT((now.report.p_WT - p_WT).norm(), 2e-3) << "joints of the arm's lengths, and a tip that they give";
  EXPECT_LT((now.report.p_WT - arm::tipPosition(geometry, now.report.sample.q_rad)).norm(), 1e-12);
  EXPECT_EQ(now.report.fault.kind, FaultKind::None) << "the change of the arm is no motion of the hand";
  ASSERT_TRUE(desk.perform("joint.set", 1, 30.0));
  arm::JointAngles q_rad = now.report.sample.q_rad;
  q_rad[0] = 30.0 * kRadPerDegree;
  EXPECT_NEAR((desk.arm().setpoint().p_WT - arm::tipPosition(geometry, q_rad)).norm(), 0.0, 1e-3);
  desk.open("02_sphere");
  desk.handTo(p_WT);
  EXPECT_LT((desk.host().snapshot().report.p_WT - p_WT).norm(), 2e-3);
}

TEST(KinematicsPanel, TheSolutionsAreCountedAndOneIsShownUntilNoneIs) {
  Desk desk(kinematicsFeature());
  desk.show();
  EXPECT_TRUE(desk.label("panel.kinematics.solutions.status").contains("8 solutions")) << "a pose in the middle";
  auto* solutions = desk.window().findChild<SolutionsSection*>();
  ASSERT_TRUE(desk.perform("solution.show", 3));
  EXPECT_EQ(solutions->chosen(), 3);
  EXPECT_FALSE(desk.label("panel.kinematics.solutions.angles").isEmpty());
  EXPECT_FALSE(desk.perform("solution.show", 9));
  ASSERT_TRUE(desk.perform("solution.show", 0));
  EXPECT_EQ(solutions->chosen(), 0);
}

/// What stands in the field of a joint, from 1.
double fieldOf(Desk& desk, int joint) {
  return desk.find<QDoubleSpinBox>(QString("panel.kinematics.joint.%1.number").arg(joint))->value();
}

TEST(KinematicsPanel, WhatIsTypedForAJointIsWhatStandsThere) {
  Desk desk(kinematicsFeature());
  desk.show();
  for (const double angle_deg : {30.0, 10.0, -25.0}) {
    for (int joint = 1; joint <= 6; ++joint) {
      const double typed_deg = joint == 5 ? 60.0 + angle_deg : angle_deg;
      desk.find<QDoubleSpinBox>(QString("panel.kinematics.joint.%1.number").arg(joint))->setValue(typed_deg);
      desk.run(3000);
      const bool stands = std::abs(fieldOf(desk, joint) - typed_deg) < 0.051;
      const QString state = desk.label(QString("panel.kinematics.joint.%1.state").arg(joint));
      const QString note = desk.label("panel.kinematics.joints.note");
      EXPECT_TRUE(stands || state == "at limit" || note.contains(QString("joint %1 steps by").arg(joint)))
          << joint << ": " << typed_deg << ", read " << fieldOf(desk, joint) << ' ' << note.toStdString();
      EXPECT_TRUE(stands || joint == 2 || joint > 3) << joint;
    }
  }
}

TEST(KinematicsPanel, TheArmMovesToASolutionWhereItIsSimulatedAndElseIsToldWhyNot) {
  Desk desk(kinematicsFeature(), "30_ur5e_table");
  desk.show();
  desk.run(500);
  auto* const move = desk.window().findChild<QPushButton*>("panel.kinematics.solutions.move");
  ASSERT_NE(move, nullptr);
  EXPECT_FALSE(move->isEnabled()) << "none is chosen";
  const arm::JointAngles wanted = desk.window().findChild<SolutionsSection*>()->find(3)->q;
  ASSERT_TRUE(desk.perform("solution.show", 3));
  ASSERT_TRUE(move->isEnabled());
  move->click();
  desk.run(1500);
  const arm::JointAngles q_rad = desk.host().snapshot().report.sample.q_rad;
  for (std::size_t joint = 0; joint < 6; ++joint)
    EXPECT_NEAR(std::remainder(q_rad[joint] - wanted[joint], 2.0 * kPi), 0.0, 2e-3) << joint;
  desk.perform("session.start");
  desk.run(500);
  EXPECT_FALSE(move->isEnabled());
  EXPECT_TRUE(desk.label("panel.kinematics.solutions.why_not").contains("Stop"));
  EXPECT_FALSE(desk.perform("solution.move", 3));
  desk.perform("session.stop");
  desk.open("02_sphere");
  desk.run(500);
  ASSERT_TRUE(desk.perform("solution.show", 3)) << "outside the limits of the Omni";
  EXPECT_FALSE(move->isEnabled());
  EXPECT_TRUE(desk.label("panel.kinematics.solutions.why_not").contains("limits"));
}

TEST(KinematicsPanel, ASwitchOfThePanelIsThatOfTheView) {
  Desk desk(kinematicsFeature());
  auto* box = desk.find<QCheckBox>("panel.kinematics.layer.ghosts");
  ASSERT_FALSE(desk.view().layers().ghosts);
  box->setChecked(true);
  EXPECT_TRUE(desk.view().layers().ghosts);
  desk.perform("layer.ghosts", false);
  EXPECT_FALSE(box->isChecked());
}

}  // namespace underact::gui::test
