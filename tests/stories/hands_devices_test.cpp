// The hands' devices themselves: GLFW, 3D mice, and another arm in the place of the simulated one.
#include <QListWidget>
#include <QPlainTextEdit>

#include "app/gui/arms/fix_dialog.h"
#include "device/input/controllers.h"
#include "device/input/space_mice.h"
#include "tests/openhaptics/stand_in.h"
#include "tests/stories/hands_desk.h"
#include "tests/support/space_mouse_double.h"

namespace underact::gui::test {

TEST(HandDevicesStory, WithoutAScreenForGlfwItIsSaidAndTheKeysWork) {
  const QByteArray display = qgetenv("DISPLAY");
  qputenv("DISPLAY", ":987");  // where nobody listens
  Controllers controllers;     // the real ones
  EXPECT_TRUE(controllers.poll().empty());
  qputenv("DISPLAY", display);
  Story story("02_sphere", {.hands = {&controllers}});
  story.perform("dock.hands", true);
  story.run(1);
  const QString given = story.find<QLabel>("panel.hands.trouble")->text();
  EXPECT_TRUE(given.startsWith("Game controllers cannot be read here")) << given.toStdString();
  EXPECT_TRUE(given.contains("Mouse, keyboard and 3D mice still work")) << given.toStdString();
  EXPECT_TRUE(story.find("panel.hands.trouble")->isVisible());
  story.perform("view.front");
  story.settle(400);
  story.perform("view.focus");
  const Vec3 before = story.arm().setpoint().p_WT;
  story.key(Qt::Key_Right);
  EXPECT_NEAR(story.arm().setpoint().p_WT.x(), before.x() + 0.002, 1e-9);
}

TEST(HandDevicesStory, WithAScreenGlfwBegins) {
  for (int round = 0; round < 2; ++round) {  // a second window, too
    Controllers controllers;
    controllers.poll();
    EXPECT_EQ(controllers.trouble(), "");
  }
}

TEST(HandDevicesStory, A3dMouseMovesAndTurnsTheStylus) {
  QDir(mapFolder()).removeRecursively();
  underact::test::SpaceMouseDouble bus;
  SpaceMice mice(bus, 20'000'000);
  Story story("02_sphere", {.hands = {&mice}});
  story.perform("dock.hands", true);
  const auto axis = [&](std::size_t number) {
    const std::vector<DeviceState> seen = mice.poll();
    return seen.empty() ? 0.0 : seen[0].readings.axis[number];
  };
  ASSERT_TRUE(comes([&] { return !mice.poll().empty(); }));
  story.run(10);
  const sim::HandSetpoint before = story.arm().setpoint();
  bus.hold({350, 0, -350}, {0, 0, 0});  // to the right and up
  ASSERT_TRUE(comes([&] { return axis(0) == 1.0 && axis(2) == -1.0; }));
  story.run(100);
  const sim::HandSetpoint shifted = story.arm().setpoint();
  EXPECT_NEAR(shifted.p_WT.x(), before.p_WT.x() + 0.012, 1e-9);
  EXPECT_NEAR(shifted.p_WT.y(), before.p_WT.y() + 0.012, 1e-9);
  EXPECT_FALSE(shifted.turns);
  bus.hold({0, 0, 0}, {0, 350, 0});
  ASSERT_TRUE(comes([&] { return axis(0) == 0.0 && axis(4) == 1.0; }));
  story.run(100);
  const sim::HandSetpoint turned = story.arm().setpoint();
  EXPECT_TRUE(turned.turns);
  story.run(100);
  const double turn_rad = Eigen::AngleAxisd(turned.R_WT.transpose() * story.arm().setpoint().R_WT).angle();
  EXPECT_NEAR(turn_rad, 0.15, 1e-9);  // 1.5 rad/s for 0.1 s
  bus.rest();
  ASSERT_TRUE(comes([&] { return axis(4) == 0.0; }));
  EXPECT_EQ(story.find<QListWidget>("panel.hands.list")->item(1)->text().section(QChar(0x2013), 0, 0).trimmed(),
            "SpaceNavigator");
}

TEST(HandDevicesStory, A3dMouseThatMayNotBeReadSaysTheCommand) {
  underact::test::SpaceMouseDouble bus;
  bus.is_allowed = false;
  SpaceMice mice(bus, 20'000'000);
  Story story("02_sphere", {.hands = {&mice}});
  story.perform("dock.hands", true);
  ASSERT_TRUE(comes([&] { return story.find<QListWidget>("panel.hands.list")->count() == 2; }));
  EXPECT_EQ(story.find<QLabel>("panel.hands.about")->text(), "You do not have permission to read /dev/hidraw3.");
  EXPECT_FALSE(story.find("panel.hands.editor")->isVisible());
  story.click(story.find("panel.hands.fix"));
  auto* dialog = story.find<FixDialog>("dialog.fix");
  ASSERT_NE(dialog, nullptr);
  EXPECT_TRUE(dialog->findChild<QPlainTextEdit*>()->toPlainText().contains("ATTRS{idVendor}==\"046d\""));
  dialog->close();
}

TEST(HandDevicesStory, WhileAnotherArmIsInPlaceNothingMoves) {
  auto* library = underact::test::standIn();
  ASSERT_NE(library, nullptr);
  library->reset();
  library->plug(true);
  ScriptedPad pad;
  Story story("02_sphere", {.hands = {&pad}, .servo = {.watchdog_s = 2.0, .max_late = 1'000'000}});
  story.perform("dock.hands", true);
  ASSERT_TRUE(story.perform("devices.use", QString("openhaptics")));
  ASSERT_TRUE(comes([&] { return story.find<QLabel>("panel.devices.in_use")->text().contains("Untested"); }));
  const Vec3 before = story.arm().setpoint().p_WT;
  pad.push(0, 1.0);
  story.run(500);
  EXPECT_EQ(story.arm().setpoint().p_WT, before);
  EXPECT_TRUE(comes(
      [&] { return story.find<QLabel>("panel.hands.state")->text().startsWith("The input devices have no effect"); }));
  story.perform("session.start");
  ASSERT_TRUE(comes([&] { return story.snapshot().mode == servo::Mode::Running; }));
  pad.press(0b10);  // Stop is for any arm
  EXPECT_TRUE(comes([&] { return story.snapshot().mode == servo::Mode::Idle; }));
  pad.rest();
  story.perform("devices.simulated");
  story.run(100);
  pad.push(0, 1.0);
  EXPECT_TRUE(comes([&] { return story.arm().setpoint().p_WT.x() > before.x(); }));
  library->reset();
}

}  // namespace underact::gui::test
