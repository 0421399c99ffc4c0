#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSlider>
#include <QStyle>
#include <QStyleOptionSlider>

#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

QPoint handleOf(const QSlider* slider) {
  QStyleOptionSlider option;
  option.initFrom(slider);
  option.orientation = Qt::Horizontal;
  option.minimum = slider->minimum();
  option.maximum = slider->maximum();
  option.sliderPosition = option.sliderValue = slider->value();
  option.subControls = QStyle::SC_All;
  return slider->style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, slider).center();
}

const scene::Gains& gainsOf(Story& story) {
  return scene::controlOf(story.host().scene(), 0).gains;
}

// A stylus that rests where the sphere pulls it along z only, and below the clamp.
void restAgainstTheSphere(Story& story) {
  sim::HandSetpoint setpoint;
  setpoint.p_WT = Vec3(0.0, 0.0, 0.0515);
  story.arm().setSetpoint(setpoint);
  story.perform("session.start");
  story.run(3000);
}

}  // namespace

TEST(FeelStory, AKeyOnASliderChangesTheForceFromTheNextTickOn) {
  Story story("02_sphere");
  restAgainstTheSphere(story);
  const double before_N = story.force_N();
  ASSERT_GT(before_N, 0.1);
  story.find("panel.gains.kp.x.slider")->setFocus();
  story.key(Qt::Key_PageUp);  // 0.1 N/mm more, and the axes are linked
  EXPECT_DOUBLE_EQ(gainsOf(story).kp_N_per_mm.z(), 0.6);
  story.run(1);
  EXPECT_EQ(story.snapshot().revision, story.host().revision());
  story.run(1);
  EXPECT_GT(story.force_N(), before_N);
  story.run(100);  // five time constants of the fade; friction keeps the stylus where it is
  EXPECT_NEAR(story.force_N() / before_N, 0.6 / 0.5, 0.05);
}

TEST(FeelStory, ADragTakesEffectWhileDraggingAndIsOneStepBack) {
  Story story("02_sphere");
  auto* slider = story.find<QSlider>("panel.gains.kp.x.slider");
  const QPoint from = handleOf(slider);
  story.press(slider, from);
  for (int step = 1; step <= 5; ++step) {
    const double before = gainsOf(story).kp_N_per_mm.x();
    story.moveTo(slider, from + QPoint(4 * step, 0));
    EXPECT_GT(gainsOf(story).kp_N_per_mm.x(), before);
  }
  story.release(slider, from + QPoint(20, 0));
  EXPECT_EQ(story.window().document().undoStack().count(), 1);
  EXPECT_TRUE(story.window().isWindowModified());
  story.key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_DOUBLE_EQ(gainsOf(story).kp_N_per_mm.x(), 0.5);
  EXPECT_FALSE(story.window().isWindowModified());
  story.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_GT(gainsOf(story).kp_N_per_mm.x(), 0.5);
}

TEST(FeelStory, TypingADoubleClickAndTheButtonSetAndReset) {
  Story story("02_sphere");
  auto* number = story.find<QDoubleSpinBox>("panel.gains.kp.y.number");
  story.type(number, "0.75");
  EXPECT_DOUBLE_EQ(gainsOf(story).kp_N_per_mm.y(), 0.75);
  auto* slider = story.find<QSlider>("panel.gains.kp.y.slider");
  QTest::mouseDClick(slider, Qt::LeftButton, {}, handleOf(slider));
  EXPECT_DOUBLE_EQ(gainsOf(story).kp_N_per_mm.y(), 0.5);
  story.type(number, "0.25");
  story.click(story.find("panel.feel.button.gains.reset"));
  EXPECT_DOUBLE_EQ(gainsOf(story).kp_N_per_mm.y(), 0.5);
}

TEST(FeelStory, LinkedAxesMoveTogetherAndUnlinkedOnesAlone) {
  Story story("02_sphere");
  auto* link = story.find<QCheckBox>("panel.feel.link");
  ASSERT_TRUE(link->isChecked());
  story.type(story.find("panel.gains.kp.x.number"), "0.4");
  EXPECT_EQ(gainsOf(story).kp_N_per_mm, Vec3::Constant(0.4));
  story.click(link, QPoint(8, link->height() / 2));
  ASSERT_FALSE(link->isChecked());
  story.type(story.find("panel.gains.kp.x.number"), "0.3");
  EXPECT_EQ(gainsOf(story).kp_N_per_mm, Vec3(0.3, 0.4, 0.4));
  EXPECT_TRUE(story.find("panel.feel.anisotropy")->isVisible());  // now it matters which nearest point is meant
}

TEST(FeelStory, AZeroGainBesideOthersIsRefusedWithASentenceAndTheOldOneStays) {
  Story story("02_sphere");
  auto* link = story.find<QCheckBox>("panel.feel.link");
  story.click(link, QPoint(8, link->height() / 2));
  auto* number = story.find<QDoubleSpinBox>("panel.gains.kp.x.number");
  const std::uint64_t before = story.host().revision();
  story.type(number, "0");
  auto* refusal = story.find<QLabel>("panel.feel.refusal");
  EXPECT_TRUE(refusal->isVisible());
  EXPECT_TRUE(refusal->text().contains("euclidean")) << refusal->text().toStdString();
  EXPECT_EQ(story.host().revision(), before);
  story.run(1);  // the next snapshot puts it back
  EXPECT_DOUBLE_EQ(number->value(), 0.5);
  EXPECT_EQ(story.window().document().undoStack().count(), 0);
  story.type(number, "0.6");
  EXPECT_FALSE(refusal->isVisible());
}

TEST(FeelStory, BeyondTheLimitIsAmberWithAReasonAndNotForbidden) {
  Story story("02_sphere");
  auto* warning = story.find<QLabel>("panel.feel.warning");
  EXPECT_FALSE(warning->isVisible());
  story.type(story.find("panel.gains.kp.x.number"), "3");
  EXPECT_TRUE(warning->isVisible());
  EXPECT_TRUE(warning->text().contains("2.67 N/mm")) << warning->text().toStdString();
  EXPECT_DOUBLE_EQ(gainsOf(story).kp_N_per_mm.x(), 3.0);
}

TEST(FeelStory, TheLawBringsItsGains) {
  Story story("02_sphere");
  EXPECT_FALSE(story.find("panel.gains.kd.x")->isVisible());
  story.find("panel.feel.law")->setFocus();
  story.key(Qt::Key_Down);
  EXPECT_EQ(scene::controlOf(story.host().scene(), 0).law, scene::LawType::PD);
  EXPECT_TRUE(story.find("panel.gains.kd.x")->isVisible());
  EXPECT_FALSE(story.find("panel.gains.ki.x")->isVisible());
  story.key(Qt::Key_Down);
  EXPECT_TRUE(story.find("panel.gains.ki.x")->isVisible());
}

TEST(FeelStory, TheSameGainsOnTheJointsFeelAndReadOtherwise) {
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("session.start"));
  story.arm().setSetpoint({Vec3(0.02, 0.01, 0.055), Vec3::Zero(), Mat3::Identity(), false});
  story.run(1500);
  const Vec3 on_the_tip = story.snapshot().report.f_T_W;
  ASSERT_TRUE(story.perform("space.set", "joint"));
  story.run(1500);
  EXPECT_EQ(story.snapshot().revision, story.host().revision());
  EXPECT_GT((story.snapshot().report.f_T_W - on_the_tip).norm(), 0.05);
  auto* row = story.find<QWidget>("panel.gains.kp.x");
  ASSERT_NE(row, nullptr);
  EXPECT_EQ(row->findChild<QLabel*>()->text(), QString::fromUtf8("q1–q3")) << "one row while they are linked";
  EXPECT_TRUE(story.find<QDoubleSpinBox>("panel.gains.kp.x.number")->accessibleName().contains("q1"));
  ASSERT_TRUE(story.perform("edit.undo"));
  story.run(1500);
  EXPECT_EQ(row->findChild<QLabel*>()->text(), "x y z");
  EXPECT_FALSE(story.find("panel.gains.kp.y")->isVisible());
  story.find<QCheckBox>("panel.feel.link")->click();
  EXPECT_TRUE(story.find("panel.gains.kp.y")->isVisible());
  story.run(100);
  EXPECT_EQ(row->findChild<QLabel*>()->text(), "x");
}

}  // namespace underact::gui::test
