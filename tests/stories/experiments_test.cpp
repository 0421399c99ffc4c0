// The guide's worksheets, done in the window: it shows what the page of answers says comes out.
#include <gtest/gtest.h>

#include <QLabel>
#include <QTableWidget>
#include <cmath>

#include "app/gui/kit/number_table.h"
#include "tests/stories/mesh_desk.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

QString labelOf(Story& story, const char* label) {
  return story.find<QLabel>(label)->text();
}

double number(Story& story, const char* table, int row, int column) {
  QString text = story.find<NumberTable>(table)->text(row, column);
  return text.replace(QChar(0x2212), '-').toDouble();
}

/// The hand by the keys, seen from the front: 2 mm a press, with Shift 10 mm, and time to get there.
void press(Story& story, Qt::Key key, int times, Qt::KeyboardModifiers modifiers = {}) {
  for (int time = 0; time < times; ++time) {
    story.key(key, modifiers);
    story.run(400);
  }
}

void moveByKeys(Story& story) {
  ASSERT_TRUE(story.perform("view.front"));
  ASSERT_TRUE(story.perform("session.start"));
  ASSERT_TRUE(story.perform("view.focus"));
}

}  // namespace

TEST(ExperimentsStory, TheWayAndTheForceOfASpringAreOnALine) {
  Story story("01_point");
  story.type(story.find("panel.gains.kp.x.number"), "0.1");
  moveByKeys(story);
  press(story, Qt::Key_PageUp, 5, Qt::ShiftModifier);  // it starts 50 mm before the middle
  int steps = 0;
  for (double last_mm = 0.0; steps < 4; ++steps) {
    press(story, Qt::Key_Right, 1);
    const double travel_mm = 1e3 * story.snapshot().report.held[0].distance_m;
    EXPECT_GT(travel_mm, last_mm + 0.5) << "after press " << steps + 1;
    EXPECT_NEAR(story.force_N(), 0.1 * travel_mm, 1e-9);
    last_mm = travel_mm;
  }
}

TEST(ExperimentsStory, AmberGoesWhereTheAnswersSay) {
  Story story("24_too_stiff");
  for (const auto& [rate_hz, border] : {std::pair{500, "1.33"}, std::pair{1000, "2.67"}, std::pair{2000, "5.33"}}) {
    ASSERT_TRUE(story.perform("servo.rate", rate_hz));
    story.run(10);
    const double amber = QString(border).toDouble();
    story.type(story.find("panel.gains.kp.x.number"), QString::number(amber + 0.02));
    EXPECT_TRUE(story.find("panel.feel.warning")->isVisible()) << rate_hz;
    EXPECT_TRUE(labelOf(story, "panel.feel.warning").contains(border)) << rate_hz;
    story.type(story.find("panel.gains.kp.x.number"), QString::number(amber - 0.02));
    EXPECT_FALSE(story.find("panel.feel.warning")->isVisible()) << rate_hz;
  }
}

TEST(ExperimentsStory, DampingTakesTheSwingOutOfAStepResponse) {
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("dock.step", true));
  ASSERT_TRUE(story.perform("step.law", QString("P")));
  for (const auto& [key, value] : {std::pair{"mass", 0.1}, std::pair{"damping", 4.0}, std::pair{"kp", 0.5}})
    ASSERT_TRUE(story.perform("step.set", QString(key), value));
  constexpr int kOvershoot = 4, kZeta = 6;  // rows
  EXPECT_NEAR(number(story, "panel.step.table", kOvershoot, 0), 39.6, 0.05);
  EXPECT_NEAR(number(story, "panel.step.table", kZeta, 0), 0.28, 0.005);
  ASSERT_TRUE(story.perform("step.law", QString("PD")));
  ASSERT_TRUE(story.perform("step.set", QString("kd"), 0.005));
  EXPECT_NEAR(number(story, "panel.step.table", kOvershoot, 0), 7.5, 0.05);
}

TEST(ExperimentsStory, TheTableOfAnArmSaysWhereItsWristIs) {
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("dock.dh", true));
  ASSERT_TRUE(story.perform("dh.start", QString("planar")));
  ASSERT_TRUE(story.perform("dh.follow", false));
  for (const auto& [row, key, text] : {std::tuple{2, "a", "280"}, {3, "a", "250"}, {1, "q", "30"}, {2, "q", "60"}})
    ASSERT_TRUE(story.perform("dh.set", row, QString(key), QString(text)));
  story.run(200);
  EXPECT_NEAR(number(story, "panel.dh.tip", 0, 0), 242.5, 0.05);
  EXPECT_NEAR(number(story, "panel.dh.tip", 0, 1), 390.0, 0.05);
}

TEST(ExperimentsStory, TwoQuarterTurnsOfABookEndApart) {
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("dock.transform", true));
  ASSERT_TRUE(story.perform("transform.axes", QString("fixed")));
  story.find<QTableWidget>("panel.transform.steps")->setCurrentCell(2, 0);
  ASSERT_TRUE(story.perform("transform.remove"));
  for (const auto& [angle, apart] : {std::pair{"90", "120.0°"}, std::pair{"45", "33.7°"}, std::pair{"10", "1.7°"}}) {
    ASSERT_TRUE(story.perform("transform.set", 1, QString("Rx"), QString(angle)));
    ASSERT_TRUE(story.perform("transform.set", 2, QString("Rz"), QString(angle)));
    EXPECT_TRUE(labelOf(story, "panel.transform.apart").contains(apart))
        << labelOf(story, "panel.transform.apart").toStdString();
  }
}

TEST(ExperimentsStory, ASecondSolutionIsWithinTheLimitsWhereJointFourIsTurnedAside) {
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("view.kinematics"));
  for (const auto& [angle_deg, within] : {std::pair{33.0, "1 within"}, std::pair{36.0, "2 within"}}) {
    ASSERT_TRUE(story.perform("joint.set", 4, angle_deg));
    story.run(2000);
    EXPECT_TRUE(labelOf(story, "panel.kinematics.solutions.status").contains(within))
        << labelOf(story, "panel.kinematics.solutions.status").toStdString();
  }
}

TEST(ExperimentsStory, ATargetSticksToTheBracketUntilThePushLeavesTheCone) {
  Story story("27_bracket");
  ASSERT_TRUE(waitForMeshes(story));
  story.type(story.find("panel.gains.kp.x.number"), "0.1");
  moveByKeys(story);
  press(story, Qt::Key_Down, 8);
  press(story, Qt::Key_PageUp, 5, Qt::ShiftModifier);
  for (int presses = 0; presses < 20 && story.snapshot().report.p_WT.z() > -0.0215; ++presses)
    press(story, Qt::Key_PageUp, 1);
  const Vec3 before_W = story.snapshot().report.held[0].p_WP;
  double share = 0.0;
  for (int presses = 0; presses < 10; ++presses) {
    const tick::TickReport report = story.snapshot().report;
    const Vec3 p_PT_W = report.p_WT - report.held[0].p_WP;
    if ((report.held[0].p_WP - before_W).norm() > 1e-4) break;
    share = std::hypot(p_PT_W.x(), p_PT_W.y()) / -p_PT_W.z();
    EXPECT_LT(share, 0.5 + 1e-6);
    press(story, Qt::Key_Right, 1);
  }
  EXPECT_GT(share, 0.2) << "it held for some steps";
  EXPECT_GT((story.snapshot().report.held[0].p_WP - before_W).norm(), 1e-4) << "and let go";
}

}  // namespace underact::gui::test
