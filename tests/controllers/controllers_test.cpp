#include "device/input/controllers.h"

#include <gtest/gtest.h>
#include <linux/input.h>

#include "tests/controllers/kernel_pad.h"
#include "tests/support/comes.h"

namespace underact::device::input {
namespace {

using test::comes;
using test::KernelPad;
using test::KernelPadKind;

const KernelPadKind kPad{
    "Microsoft X-Box 360 pad",
    0x045e,
    0x028e,
    {BTN_A, BTN_B, BTN_X, BTN_Y, BTN_TL, BTN_TR, BTN_SELECT, BTN_START, BTN_MODE, BTN_THUMBL, BTN_THUMBR},
    {{ABS_X, -32768, 32767},
     {ABS_Y, -32768, 32767},
     {ABS_Z, 0, 255},
     {ABS_RX, -32768, 32767},
     {ABS_RY, -32768, 32767},
     {ABS_RZ, 0, 255},
     {ABS_HAT0X, -1, 1},
     {ABS_HAT0Y, -1, 1}}};
const KernelPadKind kStick{
    "Nobody's joystick", 0x1234, 0x5678, {BTN_TRIGGER, BTN_THUMB}, {{ABS_X, 0, 1023}, {ABS_Y, 0, 1023}}};
const KernelPadKind kSpaceMouse{"3Dconnexion SpaceNavigator", 0x046d, 0xc626, {BTN_0, BTN_1}, {{ABS_X, -350, 350}}};

constexpr double kCount = 2.0 / 65535.0;  // of a stick whose ends stand 65535 counts apart

class ControllersTest : public testing::Test {
 protected:
  DeviceState first() {
    const std::vector<DeviceState> seen = controllers_.poll();
    return seen.empty() ? DeviceState{} : seen.front();
  }
  bool isThere() { return !controllers_.poll().empty(); }
  Readings readings() { return first().readings; }

  Controllers controllers_;
};

}  // namespace

TEST_F(ControllersTest, NothingIsPluggedInAndNothingIsWrong) {
  EXPECT_TRUE(controllers_.poll().empty());
  EXPECT_EQ(controllers_.trouble(), "");
}

TEST_F(ControllersTest, AGamepadIsKnownByItsLayout) {
  KernelPad pad(kPad);
  pad.plugIn();
  ASSERT_TRUE(isThere()) << controllers_.trouble();
  EXPECT_EQ(first().kind, InputKind::Controller);
  EXPECT_EQ(first().id, "030000005e0400008e02000010010000");
  EXPECT_EQ(readings().axes, 6);
  EXPECT_EQ(readings().buttons, 15);
  EXPECT_NE(first().default_value, Map{});
  EXPECT_TRUE(first().missing.empty());
}

TEST_F(ControllersTest, SticksTriggersAndButtonsAreReadWhereTheyStand) {
  KernelPad pad(kPad);
  pad.plugIn();
  ASSERT_TRUE(isThere());
  EXPECT_NEAR(readings().axis[0], 0.0, kCount);
  EXPECT_EQ(readings().axis[4], -1.0);  // a trigger at rest
  pad.move(ABS_X, 16384);
  EXPECT_TRUE(comes([&] { return std::abs(readings().axis[0] - 0.5) < 2 * kCount; })) << readings().axis[0];
  pad.move(ABS_Z, 255);
  EXPECT_TRUE(comes([&] { return readings().axis[4] == 1.0; })) << readings().axis[4];
  pad.press(BTN_A, true);
  EXPECT_TRUE(comes([&] { return readings().pressed == 1U; })) << readings().pressed;
  pad.press(BTN_A, false);
  EXPECT_TRUE(comes([&] { return readings().pressed == 0U; }));
}

TEST_F(ControllersTest, UnpluggedItIsGoneAndPluggedInAgainItIsTheSame) {
  KernelPad pad(kPad);
  pad.plugIn();
  ASSERT_TRUE(isThere());
  const std::string id = first().id;
  pad.press(BTN_B, true);
  ASSERT_TRUE(comes([&] { return readings().isPressed(1); }));
  for (int time = 0; time < 5; ++time) {
    pad.unplug();
    ASSERT_TRUE(comes([&] { return !isThere(); }));
    pad.plugIn();
    ASSERT_TRUE(comes([&] { return isThere(); }));
    EXPECT_EQ(first().id, id);
    EXPECT_EQ(readings().pressed, 0U) << "a button held when the cable went is held no more";
  }
}

TEST_F(ControllersTest, AJoystickOfNoKnownLayoutIsReadByNumbers) {
  KernelPad stick(kStick);
  stick.plugIn();
  ASSERT_TRUE(isThere());
  EXPECT_EQ(first().kind, InputKind::Joystick);
  EXPECT_EQ(first().name, kStick.name);
  EXPECT_EQ(readings().axes, 2);
  EXPECT_EQ(readings().buttons, 2);
  stick.move(ABS_Y, 1023);
  EXPECT_TRUE(comes([&] { return readings().axis[1] == 1.0; }));
  stick.press(BTN_THUMB, true);
  EXPECT_TRUE(comes([&] { return readings().isPressed(1); }));
}

TEST_F(ControllersTest, ASpaceMouseIsLeftToItsOwnDriver) {
  KernelPad mouse(kSpaceMouse);
  mouse.plugIn();
  EXPECT_TRUE(controllers_.poll().empty());
}

}  // namespace underact::device::input
