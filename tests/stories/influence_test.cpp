#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSlider>
#include <cmath>

#include "app/gui/plot/live_plot.h"
#include "core/base/units.h"
#include "tests/stories/picture_difference.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

// The stylus leans to +x, the tip is held above the ring's +y: what it points at and where it is stand apart.
void shadedAcross(Story& story, const Vec3& p_WT = Vec3(0.004, 0.046, 0.006)) {
  sim::HandSetpoint setpoint;
  setpoint.p_WT = p_WT;
  setpoint.R_WT = Eigen::AngleAxisd(0.7, Vec3::UnitY()).toRotationMatrix();
  setpoint.turns = true;
  story.arm().setSetpoint(setpoint);
  story.perform("session.start");
  story.run(3000);
}

const std::optional<scene::Influence>& influenceOf(Story& story) {
  return story.host().scene().constraints[0].influence;
}

tick::ConstraintReport heldOf(Story& story) {
  return story.snapshot().report.held[0];
}

/// So long that the target, which goes round at 2 m/s, has arrived.
constexpr int kArrived = 100;

double wrappedTurn(double angle_rad) {
  return std::remainder(angle_rad, 2.0 * kPi);
}

void expectThetaAt(Story& story, double t) {
  const target::Angles angles = heldOf(story).angles;
  const double turn_rad = wrappedTurn(angles.beta_rad - angles.alpha_rad);
  EXPECT_NEAR(wrappedTurn(angles.theta_rad - angles.alpha_rad - t * turn_rad), 0.0, 1e-12) << t;
  EXPECT_GT(std::abs(turn_rad), 0.5);  // or nothing would be shown by it
}

void clickBox(Story& story, const QString& name) {
  auto* box = story.find<QCheckBox>(name);
  story.click(box, QPoint(8, box->height() / 2));
}

}  // namespace

TEST(InfluenceStory, AKeyOnTheSliderTurnsTheTargetAndTheForceAtTheNextTick) {
  Story story("14_circle_influence");
  shadedAcross(story);
  expectThetaAt(story, 0.5);
  const Vec3 before_W = heldOf(story).p_WP;
  story.find("panel.influence.t.slider")->setFocus();
  story.key(Qt::Key_PageUp);
  ASSERT_TRUE(influenceOf(story).has_value());
  EXPECT_DOUBLE_EQ(influenceOf(story)->t, 0.55);
  story.run(1);
  EXPECT_EQ(story.snapshot().revision, story.host().revision());  // without a ramp
  EXPECT_GT((heldOf(story).p_WP - before_W).norm(), 1e-3);        // on its way
  story.run(kArrived);
  expectThetaAt(story, 0.55);
  story.run(1000);  // the step of that edit has faded out of the force
  const tick::TickReport report = story.snapshot().report;
  EXPECT_LT((report.f_T_W - 500.0 * (heldOf(story).p_WP - report.p_WT)).norm(), 1e-9);
}

TEST(InfluenceStory, ADragTakesEffectWhileDraggingAndIsOneStepBack) {
  Story story("14_circle_influence");
  shadedAcross(story);
  auto* slider = story.find<QSlider>("panel.influence.t.slider");
  const QPoint from(slider->width() / 2, slider->height() / 2);
  story.press(slider, from);
  for (int step = 1; step <= 5; ++step) {
    const double before = influenceOf(story)->t;
    story.moveTo(slider, from + QPoint(6 * step, 0));
    EXPECT_GT(influenceOf(story)->t, before);
    story.run(kArrived);
    expectThetaAt(story, influenceOf(story)->t);
  }
  story.release(slider, from + QPoint(30, 0));
  EXPECT_EQ(story.window().document().undoStack().count(), 1);
  story.key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_DOUBLE_EQ(influenceOf(story)->t, 0.5);
  EXPECT_FALSE(story.window().isWindowModified());
}

TEST(InfluenceStory, OneIsPositionOnlyAndADoubleClickGoesBackToTheScenesOwn) {
  Story story("14_circle_influence");
  shadedAcross(story);
  auto* number = story.find<QDoubleSpinBox>("panel.influence.t.number");
  story.type(number, "1");
  story.run(kArrived);
  const Vec3 p_WT = story.snapshot().report.p_WT;
  const Vec3 nearest_W = 0.05 * Vec3(p_WT.x(), p_WT.y(), 0.0).normalized();
  EXPECT_LT((heldOf(story).p_WP - nearest_W).norm(), 1e-15);
  auto* slider = story.find<QSlider>("panel.influence.t.slider");
  QTest::mouseDClick(slider, Qt::LeftButton, {}, QPoint(slider->width() - 8, slider->height() / 2));  // its handle
  EXPECT_DOUBLE_EQ(influenceOf(story)->t, 0.5);
  story.type(number, "0");
  EXPECT_DOUBLE_EQ(influenceOf(story)->t, 0.0);
  story.run(kArrived);
  EXPECT_LT((heldOf(story).p_WP - heldOf(story).arc.p_WPo).norm(), 1e-15);
  story.click(story.find("panel.feel.button.gains.reset"));
  EXPECT_DOUBLE_EQ(influenceOf(story)->t, 0.5);
}

TEST(InfluenceStory, WhatIsHalfTypedOutlivesTheNextPicture) {
  Story story("14_circle_influence");
  auto* number = story.find<QDoubleSpinBox>("panel.influence.t.number");
  number->setFocus(Qt::TabFocusReason);
  ASSERT_TRUE(story.perform("influence.set", 0.75));  // the next picture shows what has come of it
  story.key(Qt::Key_A, Qt::ControlModifier);
  story.key(Qt::Key_0);
  story.run(1);
  story.key(Qt::Key_Return);
  EXPECT_DOUBLE_EQ(influenceOf(story)->t, 0.0);
}

TEST(InfluenceStory, TheOtherEndOfTheStylusPointsTheOtherWayAndTheBlendIsTyped) {
  Story story("14_circle_influence");
  shadedAcross(story);
  const double alpha_rad = heldOf(story).angles.alpha_rad;
  story.find("panel.influence.axis")->setFocus();
  story.key(Qt::Key_Down);
  EXPECT_EQ(influenceOf(story)->stylus_axis, scene::StylusAxis::MinusZ);
  story.run(1);
  EXPECT_NEAR(std::abs(wrappedTurn(heldOf(story).angles.alpha_rad - alpha_rad)), kPi, 0.01);
  story.type(story.find("panel.influence.blend.number"), "12.5");
  EXPECT_DOUBLE_EQ(influenceOf(story)->blend_deg, 12.5);
}

TEST(InfluenceStory, ACircleWithoutOneIsGivenOneAndBack) {
  Story story("05_circle");
  auto* plot = story.find<LivePlot>("panel.plots.plot");
  auto* slider = story.find("panel.influence.t.slider");
  EXPECT_FALSE(slider->isVisible());
  EXPECT_FALSE(plot->showsAngles());
  shadedAcross(story);
  EXPECT_FALSE(heldOf(story).arc.p_WPo.allFinite());
  clickBox(story, "panel.influence.on");
  ASSERT_TRUE(influenceOf(story).has_value());
  EXPECT_TRUE(slider->isVisible());
  EXPECT_TRUE(plot->showsAngles());
  story.run(1000);  // ramped down and up
  EXPECT_EQ(story.snapshot().revision, story.host().revision());
  EXPECT_TRUE(heldOf(story).arc.p_WPo.allFinite());
  ASSERT_TRUE(story.perform("influence.set", 0.2));
  clickBox(story, "panel.influence.on");
  EXPECT_FALSE(influenceOf(story).has_value());
  EXPECT_FALSE(plot->showsAngles());
  clickBox(story, "panel.influence.on");
  EXPECT_DOUBLE_EQ(influenceOf(story)->t, 0.2);  // as it was before it was switched off
  for (int step = 0; step < 4; ++step) ASSERT_TRUE(story.perform("edit.undo"));
  EXPECT_FALSE(influenceOf(story).has_value());
  EXPECT_FALSE(story.window().isWindowModified());
}

TEST(InfluenceStory, RefusesAnInvalidValueWithTheSentenceOfTheCheck) {
  Story story("05_circle");
  story.find<QCheckBox>("panel.feel.link")->setChecked(false);
  ASSERT_TRUE(story.perform("gains.set", "kp", "x", 0.25));
  clickBox(story, "panel.influence.on");
  auto* refusal = story.find<QLabel>("panel.feel.refusal");
  EXPECT_TRUE(refusal->isVisible());
  EXPECT_TRUE(refusal->text().contains("euclidean")) << refusal->text().toStdString();
  EXPECT_FALSE(influenceOf(story).has_value());
  story.run(1);  // the next snapshot puts it back
  EXPECT_FALSE(story.find<QCheckBox>("panel.influence.on")->isChecked());
}

TEST(InfluenceStory, ItIsOfferedWhereThereIsSomethingToGoAround) {
  Story story("03_line");
  EXPECT_FALSE(story.find("panel.influence")->isVisible());
  ASSERT_TRUE(story.perform("scene.open", shippedScene("15_cylinder_influence")));
  EXPECT_TRUE(story.find("panel.influence")->isVisible());
  EXPECT_TRUE(story.find("panel.influence.blend")->isVisible());
  ASSERT_TRUE(story.perform("scene.open", shippedScene("02_sphere")));
  EXPECT_FALSE(story.perform("influence.set", 0.5));  // there is none to be set
  ASSERT_TRUE(story.perform("influence.on", true));
  EXPECT_TRUE(story.find("panel.influence.t")->isVisible());
  EXPECT_FALSE(story.find("panel.influence.blend")->isVisible());  // a sphere has no axis to blend about
  EXPECT_FALSE(story.perform("influence.set", 1.5));
  EXPECT_TRUE(story.perform("influence.on", false));
}

TEST(InfluenceStory, LooksAsItDid) {
  for (const char* theme : {"light", "dark"}) {
    Story story("14_circle_influence");
    story.perform(QString("view.theme.") + theme);
    shadedAcross(story);
    EXPECT_TRUE(story.picture().save(QString("%1/pictures/influence_window_%2.png").arg(UNDERACT_BINARY, theme)));
    EXPECT_LT(story.imageDifference(QString("influence_") + theme), kTolerance);
  }
}

TEST(InfluenceStory, TheSphereShowsTheGreatCircleAndTheCylinderItsOwn) {
  for (const char* name : {"02_sphere", "15_cylinder_influence"}) {
    Story story(name);
    story.perform("view.theme.light");
    story.perform("influence.on", true);
    shadedAcross(story, Vec3(0.000, -0.010, 0.050));
    EXPECT_LT(story.imageDifference(QString("influence_") + name), kTolerance) << name;
  }
}

TEST(InfluenceStory, ThePictureWithoutTheLayerIsNotTheSame) {
  Story story("14_circle_influence");
  shadedAcross(story);
  const QImage with = story.view().picture();
  ASSERT_TRUE(story.perform("layer.influence", false));
  story.settle();
  EXPECT_GT(worstBlockDifference(with, story.view().picture()), 2.0 * kTolerance);
}

}  // namespace underact::gui::test
