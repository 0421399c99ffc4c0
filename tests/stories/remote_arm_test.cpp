#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QTemporaryDir>

#include "app/gui/fault/fault_dialog.h"
#include "device/remote/share.h"
#include "tests/stories/story.h"
#include "tests/support/arm_double.h"

namespace underact::gui::test {
namespace {

using device::remote::KeyFolder;
using device::remote::Share;
using underact::test::ArmDouble;

/// The window with a servo of its own clock, and an arm that another program of the same person shares.
struct RemoteDesk {
  RemoteDesk() : story("02_sphere", {.servo = {.watchdog_s = 2.0, .max_late = 1'000'000}}) {
    qputenv("UNDERACT_KEYS", keys.path().toUtf8());
    arm.placeTip({0.0, 0.0, 0.045});  // 5 mm in the sphere
    share();
    story.perform("dock.devices", true);
  }
  ~RemoteDesk() {
    story.perform("devices.simulated");
    qunsetenv("UNDERACT_KEYS");
  }
  void share() {
    const device::remote::KeyPair own = KeyFolder(keys.path().toStdString()).own().value();
    auto opened =
        Share::open(std::make_unique<ArmDouble::Port>(arm),
                    {listen, own, {own.public_key}, arm.preset(), 1000, true, true}, [](const std::string&) {});
    ASSERT_TRUE(opened) << opened.problems().front().sentence;
    shared = std::move(opened).value();
    listen = shared->address();
  }
  bool comes(const std::function<bool()>& what) { return QTest::qWaitFor(what, 20'000); }
  QString label(const char* name) { return story.find<QLabel>(name)->text(); }
  bool pushes() {
    return comes([this] { return arm.force_N().norm() > 0.1; });
  }
  /// Types the address into the panel, as one would who was told it.
  bool open() {
    story.find<QLineEdit>("panel.devices.other")->setText("remote:" + QString::fromStdString(listen.text()));
    story.click(story.find("panel.devices.open"));
    return comes([this] { return label("panel.devices.in_use").contains("Untested"); });
  }

  QTemporaryDir keys;
  ArmDouble arm;
  device::remote::Address listen{"127.0.0.1", 0};
  std::unique_ptr<Share> shared;
  Story story;
};

}  // namespace

TEST(RemoteArmStory, AnArmOverTheNetworkIsOpenedByItsAddressAndPushesOnTheUsersWord) {
  RemoteDesk desk;
  ASSERT_TRUE(desk.open()) << desk.label("panel.devices.told").toStdString();
  desk.story.run(300);
  EXPECT_EQ(desk.arm.force_N(), Vec3::Zero());
  desk.story.perform("session.start");
  EXPECT_TRUE(desk.pushes());
  desk.story.savePicture("devices_remote");
  desk.story.key(Qt::Key_Escape);
  EXPECT_TRUE(desk.comes([&] { return desk.arm.force_N() == Vec3::Zero(); }));
  desk.story.perform("devices.simulated");
  EXPECT_EQ(desk.label("panel.devices.in_use"), "In use: Simulated arm.");
}

TEST(RemoteArmStory, WhereTheOtherProgramEndsThatIsSaidAndTheArmComesBackOnTheUsersWord) {
  RemoteDesk desk;
  ASSERT_TRUE(desk.open()) << desk.label("panel.devices.told").toStdString();
  desk.story.perform("session.start");
  ASSERT_TRUE(desk.pushes());
  desk.shared.reset();
  EXPECT_EQ(desk.arm.force_N(), Vec3::Zero());
  ASSERT_TRUE(desk.comes([&] { return desk.story.window().findChild<FaultDialog*>("dialog.fault") != nullptr; }));
  EXPECT_TRUE(desk.label("dialog.fault.what").startsWith("The arm stopped answering."));
  desk.share();
  desk.story.run(300);
  EXPECT_EQ(desk.arm.force_N(), Vec3::Zero());
  ASSERT_TRUE(desk.comes([&] { return desk.story.perform("servo.restart"); }));
  desk.story.perform("session.start");
  EXPECT_TRUE(desk.pushes());
}

TEST(RemoteArmStory, AnArmThatNobodySharesIsNotOpenedAndTheSimulatedOneStays) {
  RemoteDesk desk;
  desk.shared.reset();
  desk.story.find<QLineEdit>("panel.devices.other")->setText("remote:" + QString::fromStdString(desk.listen.text()));
  desk.story.click(desk.story.find("panel.devices.open"));
  ASSERT_TRUE(desk.comes([&] { return desk.story.find("panel.devices.told")->isVisible(); }));
  EXPECT_TRUE(desk.label("panel.devices.told").contains("could not be opened"));
  EXPECT_EQ(desk.label("panel.devices.in_use"), "In use: Simulated arm.");
}

}  // namespace underact::gui::test
