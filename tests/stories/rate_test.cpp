#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QToolButton>
#include <cmath>

#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

const scene::Control& controlOf(Story& story) {
  return scene::controlOf(story.host().scene(), 0);
}

// By key: a pointer would first have to scroll there.
void unfold(Story& story) {
  story.find<QToolButton>("panel.feel.rate.fold")->setFocus(Qt::TabFocusReason);
  story.key(Qt::Key_Space);
  story.settle();
}

}  // namespace

TEST(RateStory, AnotherFilterTakesEffectAtTheNextTickAndIsOneStepBack) {
  Story story("09_wall");  // a PD
  story.perform("session.start");
  story.run(500);
  unfold(story);
  auto* filter = story.find<QComboBox>("panel.rate.filter");
  ASSERT_TRUE(filter->isVisible());
  EXPECT_EQ(filter->currentIndex(), 0);
  EXPECT_TRUE(story.find("panel.rate.acceleration")->isVisible());
  filter->setCurrentIndex(1);
  EXPECT_TRUE(std::holds_alternative<scene::LowPassFilter>(controlOf(story).velocity));
  EXPECT_TRUE(story.find("panel.rate.time_constant")->isVisible());
  EXPECT_FALSE(story.find("panel.rate.acceleration")->isVisible());
  story.run(1);
  EXPECT_EQ(story.snapshot().revision, story.host().revision());  // without a ramp
  EXPECT_EQ(story.snapshot().mode, servo::Mode::Running);
  story.type(story.find("panel.rate.time_constant.number"), "5");
  EXPECT_EQ(controlOf(story).velocity, scene::Velocity(scene::LowPassFilter{5.0}));
  EXPECT_EQ(story.window().document().undoStack().count(), 2);
  story.perform("edit.undo");
  EXPECT_EQ(controlOf(story).velocity, scene::Velocity(scene::LowPassFilter{}));
  story.perform("edit.undo");
  EXPECT_EQ(controlOf(story).velocity, scene::Velocity(scene::KalmanFilter{}));
  EXPECT_EQ(filter->currentIndex(), 0);
}

TEST(RateStory, ALawWithoutARateOffersNoFilter) {
  Story story("02_sphere");
  unfold(story);
  EXPECT_FALSE(story.find("panel.rate.filter")->isVisible());
  EXPECT_TRUE(story.find("panel.rate.passivity")->isVisible());
  story.perform("law.set", QString("PID"));
  EXPECT_TRUE(story.find("panel.rate.filter")->isVisible());
}

TEST(RateStory, PassivityIsChosenInThePanelAndTheEnergyIsToldOf) {
  Story story("02_sphere");
  unfold(story);
  auto* passivity = story.find<QComboBox>("panel.rate.passivity");
  EXPECT_EQ(passivity->currentIndex(), 1) << "observe";
  story.perform("session.start");
  sim::HandSetpoint setpoint;
  setpoint.p_WT = Vec3(0.0, 0.0, 0.0515);
  story.arm().setSetpoint(setpoint);
  story.run(3000);
  EXPECT_NE(story.snapshot().report.held[0].energy_J, 0.0);
  passivity->setCurrentIndex(2);
  EXPECT_EQ(controlOf(story).passivity, control::Passivity::Control);
  passivity->setCurrentIndex(0);
  story.run(1);
  EXPECT_EQ(story.snapshot().report.held[0].energy_J, 0.0);
  EXPECT_TRUE(story.perform("passivity.set", QString("control")));
  EXPECT_FALSE(story.perform("passivity.set", QString("on")));
  EXPECT_EQ(passivity->currentIndex(), 2);
  story.click(story.find("panel.feel.button.gains.reset"));
  EXPECT_EQ(passivity->currentIndex(), 1);
}

}  // namespace underact::gui::test
