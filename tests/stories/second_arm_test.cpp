#include "app/gui/arms/second_arm.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>

#include "app/gui/kit/theme.h"
#include "tests/openhaptics/stand_in.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

/// The window with the sphere, and a second arm with a scene of its own; time by count.
struct SecondDesk {
  explicit SecondDesk(const QString& scene = "06_cylinder", const Beginning& beginning = {})
      : story("02_sphere", beginning), second(*story.window().findChild<SecondArm*>()) {
    story.perform("second.scene", shippedScene(scene));
    EXPECT_TRUE(story.perform("second.on", true));
    EXPECT_TRUE(QTest::qWaitFor([this] { return loaded(); }, kLong_ms));
  }
  bool loaded() {
    second.poll();
    return !second.isLoading();
  }
  void run(int ticks) {
    for (int done = 0; done < ticks; done += 33) {
      second.run(33);
      story.run(33);
    }
  }
  double secondForce_N() { return second.servo().snapshot().report.force.f_T_W().norm(); }
  QString label(const char* name) { return story.find<QLabel>(name)->text(); }

  Story story;
  SecondArm& second;
};

}  // namespace

TEST(SecondArmStory, ItHasASceneOfItsOwnAndStandsBesideTheFirst) {
  SecondDesk desk;
  EXPECT_EQ(desk.second.servo().scene().constraints.size(), 1U);
  EXPECT_NE(desk.second.servo().scene().title, desk.story.host().scene().title);
  EXPECT_TRUE(desk.story.view().showsSecond());
  desk.run(100);
  desk.story.settle(400);
  const QImage two = desk.story.view().picture();
  desk.story.savePicture("second_arm");
  EXPECT_TRUE(desk.story.perform("second.on", false));
  EXPECT_FALSE(desk.story.view().showsSecond());
  desk.story.settle(400);
  EXPECT_NE(desk.story.view().picture(), two);
}

TEST(SecondArmStory, BothStartAndBothStop) {
  SecondDesk desk;
  ASSERT_TRUE(desk.story.perform("session.start"));
  desk.story.arm().setSetpoint({Vec3(0.0, 0.0, 0.045), Vec3::Zero(), Mat3::Identity(), false});
  desk.run(3000);
  EXPECT_EQ(desk.story.snapshot().mode, servo::Mode::Running);
  EXPECT_EQ(desk.second.servo().snapshot().mode, servo::Mode::Running);
  EXPECT_GT(desk.story.force_N(), 0.05);
  EXPECT_GT(desk.secondForce_N(), 0.05);
  EXPECT_FALSE(desk.story.window().actions().find("session.start")->isEnabled());
  desk.story.key(Qt::Key_Escape);
  desk.run(300);
  EXPECT_EQ(desk.story.snapshot().mode, servo::Mode::Idle);
  EXPECT_EQ(desk.second.servo().snapshot().mode, servo::Mode::Idle);
  EXPECT_EQ(desk.secondForce_N(), 0.0);
}

TEST(SecondArmStory, ItsHandIsTheFirstOneInAMirror) {
  SecondDesk desk;
  desk.story.arm().setSetpoint({Vec3(0.03, 0.01, 0.06), Vec3::Zero(), Mat3::Identity(), false});
  desk.run(3000);
  const Vec3 first = desk.story.snapshot().report.p_WT, other = desk.second.servo().snapshot().report.p_WT;
  const double friction_m = 2e-3;  // what it may lag behind: its friction over the stiffness of the hand, 0.26 / 300
  EXPECT_LT((other - Vec3(-first.x(), first.y(), first.z())).norm(), 2 * friction_m);
  EXPECT_GT(first.x(), 0.02);
  desk.story.perform("second.mirror", false);
  desk.story.arm().setSetpoint({Vec3(-0.03, 0.01, 0.06), Vec3::Zero(), Mat3::Identity(), false});
  desk.run(2000);
  EXPECT_LT((desk.second.servo().snapshot().report.p_WT - other).norm(), friction_m);
}

TEST(SecondArmStory, AWrongSceneIsSaidAndTheOneBeforeStays) {
  SecondDesk desk;
  const std::string before = desk.second.servo().scene().title;
  desk.story.perform("dock.second", true);
  desk.story.perform("second.scene", temporaryFile("wrong.json", "{ not a scene"));
  EXPECT_TRUE(desk.label("panel.second.told").startsWith("The scene is unchanged. "));
  EXPECT_EQ(desk.second.servo().scene().title, before);
}

TEST(SecondArmStory, AMeshIsLoadedForItBehindTheWindow) {
  SecondDesk desk("26_bumpy_sphere");
  EXPECT_TRUE(std::holds_alternative<scene::Mesh>(desk.second.servo().scene().constraints.front().shape));
  desk.run(100);
  EXPECT_TRUE(desk.story.view().showsSecond());
}

TEST(SecondArmStory, TheFirstArmsDeviceIsNotOpenedTwiceAndAFaultOfTheSecondIsSaid) {
  underact::test::hd::Control* const library = underact::test::standIn();
  ASSERT_NE(library, nullptr);
  library->reset();
  library->plug(true);
  library->placeTip(0.0, 0.0, 0.045);
  SecondDesk desk("02_sphere", {.servo = {.watchdog_s = 2.0, .max_late = 1'000'000}});
  desk.story.perform("dock.second", true);
  const auto comes = [](const std::function<bool()>& what) { return QTest::qWaitFor(what, kLong_ms); };
  ASSERT_TRUE(desk.story.perform("second.use", QString("openhaptics")));
  ASSERT_TRUE(comes([&] { return desk.second.arms().name() == "openhaptics"; }));
  EXPECT_EQ(desk.second.servo().snapshot().mode, servo::Mode::Idle);
  ASSERT_TRUE(desk.story.perform("session.start"));
  ASSERT_TRUE(comes([&] { return underact::test::forceOf(*library).norm() > 0.1; }));
  library->plug(false);
  ASSERT_TRUE(comes([&] { return desk.story.find("panel.second.told")->isVisible(); }));
  EXPECT_TRUE(desk.label("panel.second.told").startsWith("The second arm: The arm stopped answering."));
  EXPECT_EQ(underact::test::forceOf(*library).norm(), 0.0);
  EXPECT_EQ(desk.story.snapshot().mode, servo::Mode::Running);  // the first goes on
  desk.story.perform("second.on", false);
  library->plug(true);
  ASSERT_TRUE(desk.story.perform("devices.use", QString("openhaptics")));
  ASSERT_TRUE(comes([&] { return desk.label("panel.devices.in_use").contains("Untested"); }));
  ASSERT_TRUE(desk.story.perform("second.on", true));
  EXPECT_FALSE(desk.story.perform("second.use", QString("openhaptics")));
  EXPECT_TRUE(desk.label("panel.second.told").contains("in use as the first arm"));
  desk.story.perform("devices.simulated");
}

TEST(SecondArmStory, ItsRateFollowsTheFirst) {
  SecondDesk desk;
  desk.run(33);
  ASSERT_TRUE(desk.story.perform("servo.rate", 2000));
  EXPECT_EQ(desk.second.servo().rateHz(), 2000);
}

TEST(SecondArmStory, ThePanelIsReachedByTheKeyboardAndSpeaks) {
  SecondDesk desk;
  desk.story.perform("dock.second", true);
  for (const char* name : {"on", "arm", "scene", "file", "side", "mirror"}) {
    auto* widget = desk.story.find(QString("panel.second.%1").arg(name));
    ASSERT_NE(widget, nullptr);
    EXPECT_FALSE(widget->accessibleName().isEmpty()) << name;
    EXPECT_TRUE(widget->focusPolicy() & Qt::TabFocus) << name;
  }
  desk.story.perform("second.side", true);
  EXPECT_EQ(desk.story.find<QComboBox>("panel.second.side")->currentIndex(), 0);
}

}  // namespace underact::gui::test
