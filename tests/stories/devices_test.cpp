#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>

#include "app/gui/arms/fix_dialog.h"
#include "app/gui/fault/fault_dialog.h"
#include "app/gui/model/arm_choice.h"
#include "app/gui/model/arm_search.h"
#include "app/gui/model/player.h"
#include "tests/openhaptics/stand_in.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

using underact::test::hd::Control;

/// The window with a servo of its own clock, and the stand-in for the vendor's library with its arm plugged in.
struct DevicesDesk {
  explicit DevicesDesk(const QString& scene = "02_sphere", bool first_start = true)
      : library(underact::test::standIn()),
        story(scene, {.first_start = first_start, .servo = {.watchdog_s = 2.0, .max_late = 1'000'000}}) {
    EXPECT_NE(library, nullptr);
    library->reset();
    library->plug(true);
    library->placeTip(0.0, 0.0, 0.045);  // 5 mm in the sphere
    story.perform("dock.devices", true);
  }
  ~DevicesDesk() {
    story.perform("devices.simulated");
    library->reset();
  }
  QString label(const char* name) { return story.find<QLabel>(name)->text(); }
  bool comes(const std::function<bool()>& what) { return QTest::qWaitFor(what, kLong_ms); }
  bool hasFound() {
    return comes([this] { return story.find<QListWidget>("panel.devices.list")->count() > 0; });
  }
  /// Chooses the first entry that begins so.
  void select(const QString& beginning) {
    auto* list = story.find<QListWidget>("panel.devices.list");
    for (int row = 0; row < list->count(); ++row) {
      if (!list->item(row)->text().startsWith(beginning)) continue;
      list->setCurrentRow(row);
      return;
    }
    ADD_FAILURE() << "no " << beginning.toStdString();
  }
  bool use(const QString& name) {
    EXPECT_TRUE(story.perform("devices.use", name));
    return comes([this] { return label("panel.devices.in_use").contains("Untested"); });
  }
  double force_N() const { return underact::test::forceOf(*library).norm(); }

  Control* library;
  Story story;
};

}  // namespace

TEST(DevicesStory, ThePanelSaysWhatIsThereAndWhatIsMissing) {
  DevicesDesk desk;
  ASSERT_TRUE(desk.hasFound());
  EXPECT_EQ(desk.label("panel.devices.in_use"), "In use: Simulated arm.");
  desk.select("Simulated arm – in use");
  EXPECT_FALSE(desk.story.find<QPushButton>("panel.devices.use")->isEnabled());
  EXPECT_FALSE(desk.story.find<QPushButton>("panel.devices.fix")->isEnabled());
  EXPECT_FALSE(desk.story.find<QPushButton>("panel.devices.report")->isEnabled());
  desk.select("WoodenHaptics (HID): none is plugged in");
  EXPECT_FALSE(desk.story.find<QPushButton>("panel.devices.use")->isEnabled());
  desk.select("Touch, Omni");
  EXPECT_TRUE(desk.label("panel.devices.about").contains("No Touch or Omni was found on USB"));
  EXPECT_TRUE(desk.story.find<QPushButton>("panel.devices.use")->isEnabled());  // one on FireWire is not seen
}

TEST(DevicesStory, OneButtonShowsTheCommandThatMends) {
  DevicesDesk desk;
  ASSERT_TRUE(desk.hasFound());
  desk.select("Touch, Omni");
  desk.story.click(desk.story.find("panel.devices.fix"));
  auto* dialog = desk.story.find<FixDialog>("dialog.fix");
  ASSERT_NE(dialog, nullptr);
  const QList<QPlainTextEdit*> commands = dialog->findChildren<QPlainTextEdit*>();
  ASSERT_FALSE(commands.isEmpty());
  const QString command = commands.last()->toPlainText();
  EXPECT_EQ(command, "lsusb -d 2988:");
  dialog->findChild<QPushButton*>(commands.last()->objectName().replace("command", "copy"))->click();
  EXPECT_EQ(QApplication::clipboard()->text(), command);
  dialog->close();
}

TEST(DevicesStory, AnArmIsOpenedAndPushesOnlyOnTheUsersWord) {
  DevicesDesk desk;
  desk.story.perform("session.start");
  ASSERT_TRUE(desk.use("openhaptics"));
  EXPECT_TRUE(desk.label("status.device").contains("(untested)")) << desk.label("status.device").toStdString();
  EXPECT_TRUE(desk.comes([&] { return desk.label("status.mode") == "Stopped"; }));
  desk.story.run(300);
  EXPECT_EQ(desk.force_N(), 0.0);
  desk.story.perform("session.start");
  EXPECT_TRUE(desk.comes([&] { return desk.force_N() > 0.1; }));
  desk.story.perform("devices.simulated");
  EXPECT_EQ(desk.force_N(), 0.0);
  EXPECT_FALSE(desk.library->isOpen());
  EXPECT_EQ(desk.label("panel.devices.in_use"), "In use: Simulated arm.");
  desk.story.perform("session.start");
  EXPECT_TRUE(desk.comes([&] { return desk.label("status.mode").startsWith("Running, "); }));
}

TEST(DevicesStory, AfterAReplayTheArmInSomebodysHandDoesNotPushUnasked) {
  DevicesDesk desk;
  ASSERT_TRUE(desk.use("openhaptics"));
  desk.story.perform("session.start");
  ASSERT_TRUE(desk.comes([&] { return desk.force_N() > 0.1; }));
  ASSERT_TRUE(desk.story.perform("replay.open", QString(UNDERACT_SOURCE "/tests/golden/session.h5")));
  Player& player = desk.story.window().player();
  ASSERT_TRUE(desk.comes([&] {
    desk.story.window().frame();
    return player.isOpen() && !player.isLoading();
  }));
  ASSERT_TRUE(desk.story.perform("replay.close"));
  EXPECT_TRUE(desk.comes([&] { return desk.label("status.mode") == "Stopped"; }));
  desk.story.run(300);
  EXPECT_EQ(desk.force_N(), 0.0);
}

TEST(DevicesStory, AnUnpluggedArmIsSaidAndComesBackOnTheUsersWord) {
  DevicesDesk desk;
  ASSERT_TRUE(desk.use("openhaptics"));
  desk.story.perform("session.start");
  ASSERT_TRUE(desk.comes([&] { return desk.force_N() > 0.1; }));
  desk.library->plug(false);
  ASSERT_TRUE(desk.comes([&] { return desk.story.window().findChild<FaultDialog*>("dialog.fault") != nullptr; }));
  EXPECT_EQ(desk.force_N(), 0.0);
  EXPECT_TRUE(desk.comes([&] { return desk.label("status.mode") == "Fault"; }));
  const QString given = desk.label("dialog.fault.what");
  EXPECT_TRUE(given.startsWith("The arm stopped answering.")) << given.toStdString();
  EXPECT_GT(given.size(), 40) << "nothing of what the arm's side says: " << given.toStdString();
  desk.library->plug(true);
  desk.story.run(300);
  EXPECT_EQ(desk.force_N(), 0.0);
  ASSERT_TRUE(desk.story.perform("servo.restart"));
  desk.story.run(300);
  EXPECT_EQ(desk.force_N(), 0.0);
  desk.story.perform("session.start");
  EXPECT_TRUE(desk.comes([&] { return desk.force_N() > 0.1; }));
}

TEST(DevicesStory, AnArmThatIsNotThereLeavesTheSimulatedOneAndSaysWhy) {
  DevicesDesk desk;
  desk.library->plug(false);
  auto* other = desk.story.find<QLineEdit>("panel.devices.other");
  other->setText("openhaptics");
  desk.story.click(desk.story.find("panel.devices.open"));
  ASSERT_TRUE(desk.comes([&] { return desk.story.find("panel.devices.told")->isVisible(); }));
  EXPECT_TRUE(desk.label("panel.devices.told").startsWith(QString::fromUtf8("“openhaptics” could not be opened. ")));
  EXPECT_EQ(desk.label("panel.devices.in_use"), "In use: Simulated arm.");
  EXPECT_TRUE(desk.story.perform("devices.use", QString("toaster")));
  EXPECT_TRUE(desk.comes([&] { return desk.label("panel.devices.told").contains("There is no arm of the kind"); }));
}

TEST(DevicesStory, OpeningTakesItsTimeBehindTheWindowAndCanBeCancelled) {
  DevicesDesk desk;
  desk.library->delay("hdInitDevice", 1, 1500);
  ASSERT_TRUE(desk.story.perform("devices.use", QString("openhaptics")));
  EXPECT_EQ(desk.label("panel.devices.opening"), QString::fromUtf8("Opening openhaptics…"));
  EXPECT_TRUE(desk.story.find<QProgressBar>("panel.devices.bar")->isVisible());
  const qint64 frames = desk.story.snapshot().ticks;
  desk.story.run(200);
  EXPECT_GT(desk.story.snapshot().ticks, frames);  // the simulated arm goes on
  desk.story.click(desk.story.find("panel.devices.cancel"));
  EXPECT_FALSE(desk.story.find("panel.devices.bar")->isVisible());
  EXPECT_TRUE(desk.comes([&] { return !desk.library->isOpen(); }));
  desk.story.run(2000);
  EXPECT_EQ(desk.label("panel.devices.in_use"), "In use: Simulated arm.");
  EXPECT_FALSE(desk.library->isOpen());
}

TEST(DevicesStory, NoArmIsExchangedInTheMidstOfARecording) {
  DevicesDesk desk;
  ASSERT_TRUE(desk.story.perform("session.record"));
  ASSERT_TRUE(desk.comes([&] { return desk.story.host().records(); }));
  EXPECT_FALSE(desk.story.perform("devices.use", QString("openhaptics")));
  EXPECT_TRUE(desk.label("panel.devices.told").contains("Stop the recording"));
  EXPECT_EQ(desk.story.host().device().title, "Simulated arm");
  desk.story.perform("session.record");
}

TEST(DevicesStory, TheArmIsRememberedAndAHandIsNotOfferedForIt) {
  {
    DevicesDesk desk;
    EXPECT_TRUE(desk.story.perform("joint.set", 1, 0.0));
    ASSERT_TRUE(desk.use("openhaptics"));
    EXPECT_FALSE(desk.story.perform("joint.set", 1, 10.0));  // a real arm is moved by a hand
    desk.story.window().close();
    EXPECT_EQ(QSettings().value("arm/device").toString(), "openhaptics");
  }
  DevicesDesk desk;
  desk.story.window().close();
  EXPECT_EQ(QSettings().value("arm/device").toString(), "simulated");
}

TEST(DevicesStory, ASceneForAnotherArmOpensTheArmAnew) {
  DevicesDesk desk;
  ASSERT_TRUE(desk.use("openhaptics"));
  const auto opened = desk.library->calls("hdInitDevice");
  scene::Description scene = desk.story.window().document().scene();
  scene.arm = "touch-measured";
  ASSERT_TRUE(desk.story.window().document().open(scene).empty());
  EXPECT_TRUE(desk.comes([&] { return desk.library->calls("hdInitDevice") > opened; }));
  EXPECT_TRUE(desk.comes([&] { return desk.label("panel.devices.in_use").contains("Untested"); }));
  EXPECT_TRUE(desk.comes([&] { return desk.label("status.mode") == "Stopped"; }));
}

TEST(DevicesStory, EverythingHasANameAndIsReachedByTheKeyboard) {
  DevicesDesk desk;
  ASSERT_TRUE(desk.hasFound());
  desk.select("Touch, Omni");
  for (const char* name : {"use", "fix", "look", "open", "list", "other"}) {
    auto* widget = desk.story.find(QString("panel.devices.%1").arg(name));
    ASSERT_NE(widget, nullptr);
    EXPECT_FALSE(widget->accessibleName().isEmpty()) << name;
    EXPECT_TRUE(widget->focusPolicy() & Qt::TabFocus) << name;
  }
  desk.story.savePicture("devices");
}

}  // namespace underact::gui::test
