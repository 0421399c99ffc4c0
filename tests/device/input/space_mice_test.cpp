#include "device/input/space_mice.h"

#include <gtest/gtest.h>

#include "tests/support/comes.h"
#include "tests/support/space_mouse_double.h"

namespace underact::device::input {
namespace {

using test::comes;

class SpaceMiceTest : public testing::Test {
 protected:
  static constexpr std::int64_t kSoon_ns = 20'000'000;
  DeviceState first() {
    const std::vector<DeviceState> seen = mice_.poll();
    return seen.empty() ? DeviceState{} : seen.front();
  }
  double axis(std::size_t number) { return first().readings.axis[number]; }
  bool isThere() { return !mice_.poll().empty(); }

  test::SpaceMouseDouble bus_;
  SpaceMice mice_{bus_, kSoon_ns};
};

}  // namespace

TEST_F(SpaceMiceTest, OneThatIsThereIsReadAndComesToRest) {
  ASSERT_TRUE(comes([&] { return isThere(); }));
  EXPECT_EQ(first().name, "SpaceNavigator");
  EXPECT_EQ(first().kind, InputKind::SpaceMouse);
  EXPECT_EQ(first().button_names, (std::vector<Sentence>{"left", "right"}));
  bus_.hold({350, 0, -175}, {0, 35, 0});
  EXPECT_TRUE(comes([&] { return axis(0) == 1.0 && axis(2) == -0.5 && axis(4) == 0.1; }));
  bus_.rest();
  EXPECT_TRUE(comes([&] { return axis(0) == 0.0 && axis(4) == 0.0; }));
  bus_.say({3, 2});
  EXPECT_TRUE(comes([&] { return first().readings.isPressed(1); }));
}

TEST_F(SpaceMiceTest, OneThatFallsSilentIsAtRestAndKeepsItsButtons) {
  bus_.hold({350, 0, 0}, {0, 0, 0});
  ASSERT_TRUE(comes([&] { return axis(0) == 1.0; }));
  bus_.say({3, 1});
  ASSERT_TRUE(comes([&] { return first().readings.isPressed(0); }));
  bus_.rest(true);
  EXPECT_TRUE(comes([&] { return axis(0) == 0.0; }));
  EXPECT_TRUE(first().readings.isPressed(0));
}

TEST_F(SpaceMiceTest, ItIsUnpluggedAndPluggedInAgain) {
  bus_.hold({0, 350, 0}, {0, 0, 0});
  ASSERT_TRUE(comes([&] { return axis(1) == 1.0; }));
  bus_.unplug();
  EXPECT_TRUE(comes([&] { return !isThere(); }));
  bus_.plugIn();
  EXPECT_TRUE(comes([&] { return axis(1) == 1.0; }));
}

TEST_F(SpaceMiceTest, OneThatNobodyMayReadSaysTheCommandAndWorksOnceItWasGiven) {
  bus_.is_allowed = false;
  ASSERT_TRUE(comes([&] { return isThere(); }));
  ASSERT_EQ(first().missing.size(), 1U);
  EXPECT_EQ(first().missing[0].sentence, "You do not have permission to read /dev/hidraw3.");
  EXPECT_NE(first().missing[0].command.find("ATTRS{idVendor}==\"046d\", ATTRS{idProduct}==\"c626\""),
            std::string::npos);
  bus_.is_allowed = true;
  bus_.hold({0, 0, 350}, {0, 0, 0});
  EXPECT_TRUE(comes([&] { return axis(2) == 1.0; }));
  EXPECT_TRUE(first().missing.empty());
}

TEST_F(SpaceMiceTest, AnotherHidDeviceIsNone) {
  bus_.unplug();
  bus_.node.usage = 2;
  bus_.plugIn();
  bus_.hold({350, 0, 0}, {0, 0, 0});
  std::this_thread::sleep_for(std::chrono::nanoseconds(3 * kSoon_ns));
  EXPECT_FALSE(isThere());
}

}  // namespace underact::device::input
