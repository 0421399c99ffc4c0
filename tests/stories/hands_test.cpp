#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QStandardPaths>
#include <QToolButton>

#include "app/gui/devices/fix_dialog.h"
#include "app/gui/hands/axis_bar.h"
#include "app/gui/hands/map_store.h"
#include "app/gui/hands/moving_hands.h"
#include "device/hands/controllers.h"
#include "device/hands/space_mice.h"
#include "device/hands/usual.h"
#include "device/simulated_arm.h"
#include "tests/openhaptics/stand_in.h"
#include "tests/stories/story.h"
#include "tests/support/space_mouse_double.h"

namespace underact::gui::test {
namespace {

using namespace device::hands;

constexpr int kLong_ms = 20'000;
constexpr const char* kPad = "030000005e0400008e02000010010000";

/// A game controller that does what a story says.
class ScriptedPad final : public Port {
 public:
  ScriptedPad() {
    pad.id = kPad;
    pad.name = "Xbox 360 Controller";
    pad.kind = device::hands::Kind::Controller;
    pad.readings.axes = 6;
    pad.readings.buttons = 15;
    describeController(pad);
    rest();
  }
  std::vector<Seen> look() override { return is_plugged ? std::vector{pad} : std::vector<Seen>{}; }
  std::string trouble() const override { return its_trouble; }
  void push(std::size_t axis, double value) { pad.readings.axis[axis] = value; }
  void press(unsigned bits) { pad.readings.pressed = bits; }
  void rest() {
    pad.readings.axis = {0, 0, 0, 0, -1, -1};
    pad.readings.pressed = 0;
  }
  Seen pad;
  bool is_plugged = true;
  std::string its_trouble;
};

QString mapFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) + "/hands";
}

/// A window with a controller beside it.
struct Desk {
  explicit Desk(bool first_start = true) : story_(begin(first_start)) {
    story().perform("dock.hands", true);
    story().perform("session.start");
    story().run(500);
  }
  std::unique_ptr<Story> begin(bool first_start) {
    if (first_start) QDir(mapFolder()).removeRecursively();
    return std::make_unique<Story>("02_sphere", Beginning{.first_start = first_start, .hands = {&pad}});
  }
  Story& story() { return *story_; }
  MovingHands& hands() { return *story().window().findChild<MovingHands*>(); }
  const Map& map() { return hands().find(kPad)->map; }
  Vec3 wish() { return story().arm().wished().p_WT; }
  QString label(const char* name) { return story().find<QLabel>(name)->text(); }
  /// The pad as it is now for so many ticks.
  void hold(int ticks) { story().run(ticks); }

  ScriptedPad pad;
  std::unique_ptr<Story> story_;
};

bool comes(const std::function<bool()>& what) {
  return QTest::qWaitFor(what, kLong_ms);
}

}  // namespace

TEST(HandsStory, AControllerPushesIntoTheSphereAsFastAsItsMapSays) {
  Desk desk;
  const Vec3 before = desk.wish();
  desk.pad.push(1, -1.0);  // the left stick away from the person: into the sphere
  desk.hold(100);
  EXPECT_NEAR(desk.wish().z(), before.z() - 0.012, 1e-9);  // 120 mm/s for 0.1 s
  EXPECT_EQ(desk.wish().x(), before.x());
  desk.pad.rest();
  desk.hold(1500);
  EXPECT_GT(desk.story().force_N(), 0.3);
  EXPECT_LE(desk.story().force_N(), 0.88 + 1e-9);
  EXPECT_GT(desk.story().snapshot().report.force.f_T_W().z(), 0.0);  // outwards: it pushes back
  EXPECT_NEAR(desk.wish().z(), before.z() - 0.012, 1e-9);            // nobody moves it any more
}

TEST(HandsStory, WithinTheDeadZoneNothingMovesAndBeyondItBeginsAtZero) {
  Desk desk;
  const Vec3 before = desk.wish();
  desk.pad.push(0, 0.12);
  desk.hold(1000);
  EXPECT_EQ(desk.wish(), before);
  desk.pad.push(0, 0.13);
  desk.hold(1000);
  EXPECT_GT(desk.wish().x(), before.x());
  EXPECT_LT(desk.wish().x(), before.x() + 1e-4);
  ASSERT_TRUE(desk.story().perform("hands.set", QString("right.dead_zone"), 0.5));
  desk.pad.rest();
  desk.hold(1);
  const double there = desk.wish().x();
  desk.pad.push(0, 0.49);
  desk.hold(1000);
  EXPECT_EQ(desk.wish().x(), there);
}

TEST(HandsStory, AMappingIsLearntKeptAndThereInTheNextWindow) {
  {
    Desk desk;
    desk.story().click(desk.story().find("panel.hands.way.up"));
    desk.story().click(desk.story().find("panel.hands.learn"));
    EXPECT_TRUE(desk.label("panel.hands.asked").contains("moves the stylus up"));
    const Vec3 before = desk.wish();
    desk.pad.push(3, -0.9);  // the right stick away
    desk.hold(250);
    EXPECT_EQ(desk.wish(), before);  // it is looked at, not moved by
    EXPECT_EQ(desk.map().ways[1].source, (Source{SourceKind::Axis, 3, -1}));
    EXPECT_TRUE(desk.map().ways[1].inverted);
    EXPECT_FALSE(desk.story().find("panel.hands.asked")->isVisible());
    EXPECT_EQ(desk.story().find<QComboBox>("panel.hands.source")->currentText(), "right stick, down");
    desk.story().run(250);
    EXPECT_EQ(desk.wish(), before);  // still held from before
    desk.pad.rest();
    desk.hold(1);
    desk.pad.push(3, -1.0);
    desk.hold(100);
    EXPECT_NEAR(desk.wish().y(), before.y() + 0.012, 1e-9);
  }
  Desk desk(false);
  EXPECT_EQ(desk.map().ways[1].source, (Source{SourceKind::Axis, 3, -1}));
  EXPECT_TRUE(desk.map().ways[1].inverted);
  ASSERT_TRUE(desk.story().perform("hands.reset"));
  EXPECT_EQ(desk.map(), desk.pad.pad.usual);
  EXPECT_TRUE(comes([] { return QDir(mapFolder()).entryList(QDir::Files).isEmpty(); }));  // as usual: no file
}

TEST(HandsStory, APairOfButtonsIsLearntOneAfterTheOtherAndAButtonForStop) {
  Desk desk;
  ASSERT_TRUE(desk.story().perform("hands.learn", QString("right")));
  desk.pad.press(1U << 14U);
  desk.hold(1);
  EXPECT_TRUE(desk.label("panel.hands.asked").contains("the other way"));
  desk.pad.press(0);
  desk.hold(1);
  desk.pad.press(1U << 12U);
  desk.hold(1);
  EXPECT_EQ(desk.map().ways[0].source, (Source{SourceKind::Buttons, 14, 12}));
  EXPECT_EQ(desk.hands().learning(), "");
  desk.pad.rest();
  desk.hold(1);
  ASSERT_TRUE(desk.story().perform("hands.learn", QString("stop")));
  desk.pad.press(1U << 6U);
  desk.hold(1);
  EXPECT_EQ(desk.map().presses[2], 6);
  ASSERT_TRUE(desk.story().perform("hands.undo"));
  EXPECT_EQ(desk.map().presses[2], 1);
  ASSERT_TRUE(desk.story().perform("hands.undo"));  // both buttons were one change
  EXPECT_EQ(desk.map(), desk.pad.pad.usual);
  ASSERT_TRUE(desk.story().perform("hands.redo"));
  EXPECT_EQ(desk.map().ways[0].source, (Source{SourceKind::Buttons, 14, 12}));
}

TEST(HandsStory, TheEditorChangesWhatItSays) {
  Desk desk;
  auto& story = desk.story();
  story.type(story.find<QDoubleSpinBox>("panel.hands.dead_zone.number"), "30");
  EXPECT_NEAR(desk.map().ways[0].dead_zone, 0.30, 1e-12);
  story.type(story.find<QDoubleSpinBox>("panel.hands.fine.number"), "0");
  EXPECT_EQ(desk.map().ways[0].exponent, 1.0);
  story.type(story.find<QDoubleSpinBox>("panel.hands.speed.number"), "50");
  EXPECT_NEAR(desk.map().ways[0].top, 0.05, 1e-12);
  story.find<QCheckBox>("panel.hands.inverted")->click();
  EXPECT_TRUE(desk.map().ways[0].inverted);
  EXPECT_FALSE(story.perform("hands.set", QString("right.dead_zone"), 1.5));
  EXPECT_FALSE(story.perform("hands.set", QString("right.source"), QString("axis 77")));
  EXPECT_FALSE(story.perform("hands.set", QString("left.inverted"), true));
  const Vec3 before = desk.wish();
  desk.pad.push(0, 0.65);  // half of what is left of its way
  desk.hold(200);
  EXPECT_NEAR(desk.wish().x(), before.x() - 0.005, 1e-9);
  EXPECT_NEAR(story.find<AxisBar>("panel.hands.bar.right")->share(), -0.5, 1e-12);
  story.click(story.find("panel.hands.undo"));
  EXPECT_FALSE(desk.map().ways[0].inverted);
}

TEST(HandsStory, UnpluggedInTheMidstOfAPushTheHandRests) {
  Desk desk;
  desk.pad.push(1, -1.0);
  desk.hold(80);
  desk.pad.is_plugged = false;
  desk.hold(1);
  const Vec3 left = desk.wish();
  desk.hold(2000);
  EXPECT_EQ(desk.wish(), left);
  EXPECT_LE(desk.story().force_N(), 0.88 + 1e-9);
  EXPECT_EQ(desk.story().find<QListWidget>("panel.hands.list")->count(), 1);
  desk.pad.is_plugged = true;  // with the stick where it was
  desk.hold(1000);
  EXPECT_EQ(desk.wish(), left);
  desk.pad.rest();
  desk.hold(1);
  desk.pad.push(1, 1.0);
  desk.hold(100);
  EXPECT_GT(desk.wish().z(), left.z());
}

TEST(HandsStory, OneThatIsSwitchedOffMovesNothingAndStaysSo) {
  {
    Desk desk;
    auto* list = desk.story().find<QListWidget>("panel.hands.list");
    ASSERT_EQ(list->count(), 2);
    list->item(1)->setCheckState(Qt::Unchecked);
    const Vec3 before = desk.wish();
    desk.pad.push(0, 1.0);
    desk.hold(500);
    EXPECT_EQ(desk.wish(), before);
    EXPECT_TRUE(list->item(1)->text().endsWith("switched off")) << list->item(1)->text().toStdString();
  }
  Desk desk(false);
  EXPECT_FALSE(desk.hands().find(kPad)->used);
  desk.story().perform("hands.use", QString(kPad), true);
  const Vec3 before = desk.wish();
  desk.pad.push(0, 1.0);
  desk.hold(100);
  EXPECT_GT(desk.wish().x(), before.x());
}

TEST(HandsStory, ItsButtonsAreTheStylusButtonsAndOneStopsAndNoneStarts) {
  Desk desk;
  desk.pad.press(0b101);  // A and X
  desk.hold(2);
  desk.hold(1);
  EXPECT_EQ(desk.story().snapshot().report.sample.buttons, 3U);
  desk.pad.press(0b10);  // B
  desk.hold(1);
  desk.hold(300);
  EXPECT_EQ(desk.story().snapshot().mode, servo::Mode::Idle);
  EXPECT_EQ(desk.story().snapshot().report.sample.buttons, 0U);
  for (unsigned button = 0; button < 15; ++button) {
    desk.pad.press(1U << button);
    desk.hold(20);
  }
  EXPECT_EQ(desk.story().snapshot().mode, servo::Mode::Idle);
  desk.story().perform("session.start");
  desk.hold(100);
  EXPECT_EQ(desk.story().snapshot().mode, servo::Mode::Running);
  ASSERT_TRUE(desk.story().perform("hands.use", QString(kPad), false));
  desk.pad.press(0b10);  // stops even so
  desk.hold(300);
  EXPECT_EQ(desk.story().snapshot().mode, servo::Mode::Idle);
}

TEST(HandsStory, WithoutAScreenForGlfwItIsSaidAndTheKeysWork) {
  const QByteArray display = qgetenv("DISPLAY");
  qputenv("DISPLAY", ":987");  // where nobody listens
  Controllers controllers;     // the real ones
  EXPECT_TRUE(controllers.look().empty());
  qputenv("DISPLAY", display);
  Story story("02_sphere", {.hands = {&controllers}});
  story.perform("dock.hands", true);
  story.run(1);
  const QString said = story.find<QLabel>("panel.hands.trouble")->text();
  EXPECT_TRUE(said.startsWith("Game controllers cannot be read here")) << said.toStdString();
  EXPECT_TRUE(said.contains("Mouse, keyboard and 3D mice work")) << said.toStdString();
  EXPECT_TRUE(story.find("panel.hands.trouble")->isVisible());
  story.perform("view.front");
  story.settle(400);
  story.perform("view.focus");
  const Vec3 before = story.arm().wished().p_WT;
  story.key(Qt::Key_Right);
  EXPECT_NEAR(story.arm().wished().p_WT.x(), before.x() + 0.002, 1e-9);
}

TEST(HandsStory, WithAScreenGlfwBegins) {
  for (int round = 0; round < 2; ++round) {  // a second window, too
    Controllers controllers;
    controllers.look();
    EXPECT_EQ(controllers.trouble(), "");
  }
}

TEST(HandsStory, A3dMouseMovesAndTurnsTheStylus) {
  QDir(mapFolder()).removeRecursively();
  underact::test::SpaceMouseDouble bus;
  SpaceMice mice(bus, 20'000'000);
  Story story("02_sphere", {.hands = {&mice}});
  story.perform("dock.hands", true);
  const auto axis = [&](std::size_t number) {
    const std::vector<Seen> seen = mice.look();
    return seen.empty() ? 0.0 : seen[0].readings.axis[number];
  };
  ASSERT_TRUE(comes([&] { return !mice.look().empty(); }));
  story.run(10);
  const sim::HandWish before = story.arm().wished();
  bus.hold({350, 0, -350}, {0, 0, 0});  // to the right and up
  ASSERT_TRUE(comes([&] { return axis(0) == 1.0 && axis(2) == -1.0; }));
  story.run(100);
  const sim::HandWish shifted = story.arm().wished();
  EXPECT_NEAR(shifted.p_WT.x(), before.p_WT.x() + 0.012, 1e-9);
  EXPECT_NEAR(shifted.p_WT.y(), before.p_WT.y() + 0.012, 1e-9);
  EXPECT_FALSE(shifted.turns);
  bus.hold({0, 0, 0}, {0, 350, 0});
  ASSERT_TRUE(comes([&] { return axis(0) == 0.0 && axis(4) == 1.0; }));
  story.run(100);
  const sim::HandWish turned = story.arm().wished();
  EXPECT_TRUE(turned.turns);
  story.run(100);
  const double turn_rad = Eigen::AngleAxisd(turned.R_WT.transpose() * story.arm().wished().R_WT).angle();
  EXPECT_NEAR(turn_rad, 0.15, 1e-9);  // 1.5 rad/s for 0.1 s
  bus.rest();
  ASSERT_TRUE(comes([&] { return axis(4) == 0.0; }));
  EXPECT_EQ(story.find<QListWidget>("panel.hands.list")->item(1)->text().section(QChar(0x2013), 0, 0).trimmed(),
            "SpaceNavigator");
}

TEST(HandsStory, A3dMouseThatMayNotBeReadSaysTheCommand) {
  underact::test::SpaceMouseDouble bus;
  bus.is_allowed = false;
  SpaceMice mice(bus, 20'000'000);
  Story story("02_sphere", {.hands = {&mice}});
  story.perform("dock.hands", true);
  ASSERT_TRUE(comes([&] { return story.find<QListWidget>("panel.hands.list")->count() == 2; }));
  EXPECT_EQ(story.find<QLabel>("panel.hands.about")->text(), "You may not read /dev/hidraw3.");
  EXPECT_FALSE(story.find("panel.hands.editor")->isVisible());
  story.click(story.find("panel.hands.fix"));
  auto* dialog = story.find<FixDialog>("dialog.fix");
  ASSERT_NE(dialog, nullptr);
  EXPECT_TRUE(dialog->findChild<QPlainTextEdit*>()->toPlainText().contains("ATTRS{idVendor}==\"046d\""));
  dialog->close();
}

TEST(HandsStory, WhileAnotherArmIsInPlaceNothingMoves) {
  auto* library = underact::test::standIn();
  ASSERT_NE(library, nullptr);
  library->reset();
  library->plug(true);
  ScriptedPad pad;
  Story story("02_sphere", {.hands = {&pad}, .servo = {.watchdog_s = 2.0, .max_late = 1'000'000}});
  story.perform("dock.hands", true);
  ASSERT_TRUE(story.perform("devices.use", QString("openhaptics")));
  ASSERT_TRUE(comes([&] { return story.find<QLabel>("panel.devices.in_use")->text().contains("Untested"); }));
  const Vec3 before = story.arm().wished().p_WT;
  pad.push(0, 1.0);
  story.run(500);
  EXPECT_EQ(story.arm().wished().p_WT, before);
  EXPECT_TRUE(comes([&] { return story.find<QLabel>("panel.hands.state")->text().startsWith("The hands rest"); }));
  story.perform("session.start");
  ASSERT_TRUE(comes([&] { return story.snapshot().mode == servo::Mode::Running; }));
  pad.press(0b10);  // Stop is for any arm
  EXPECT_TRUE(comes([&] { return story.snapshot().mode == servo::Mode::Idle; }));
  pad.rest();
  story.perform("devices.simulated");
  story.run(100);
  pad.push(0, 1.0);
  EXPECT_TRUE(comes([&] { return story.arm().wished().p_WT.x() > before.x(); }));
  library->reset();
}

TEST(HandsStory, AMapThatCannotBeReadIsSaidAndLeftAlone) {
  QDir(mapFolder()).removeRecursively();
  QDir().mkpath(mapFolder());
  const QString path = MapStore().pathOf(kPad);
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{\"underact_hand_map\": 1, \"id\": \"x\", \"ways\": {\"rihgt\": {}}}");
  file.close();
  Desk desk(false);
  EXPECT_EQ(desk.map(), desk.pad.pad.usual);
  EXPECT_TRUE(desk.label("panel.hands.trouble").contains("Did you mean \"right\"?"))
      << desk.label("panel.hands.trouble").toStdString();
  desk.story_.reset();
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_TRUE(file.readAll().contains("rihgt"));
  QDir(mapFolder()).removeRecursively();
}

TEST(HandsStory, EverythingHasANameAndIsReachedByTheKeyboard) {
  Desk desk;
  for (const char* name : {"list", "way.right", "way.turn_z", "source", "learn", "inverted", "press.stop", "learn.stop",
                           "undo", "redo", "reset"}) {
    auto* widget = desk.story().find(QString("panel.hands.%1").arg(name));
    ASSERT_NE(widget, nullptr);
    EXPECT_FALSE(widget->accessibleName().isEmpty()) << name;
    EXPECT_FALSE(widget->toolTip().isEmpty()) << name;
    EXPECT_TRUE(widget->focusPolicy() & Qt::TabFocus) << name;
  }
  desk.pad.push(0, 0.7);
  desk.pad.push(1, -0.3);
  desk.hold(20);
  desk.story().savePicture("hands");
}

}  // namespace underact::gui::test
