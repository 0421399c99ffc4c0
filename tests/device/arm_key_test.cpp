#include "device/arm_key.h"

#include <gtest/gtest.h>

namespace underact::device {
namespace {

TEST(ArmKey, IsKindAndSerialNumberWhereverItIsPluggedIn) {
  const servo::DeviceInfo wooden{"WoodenHaptics v1, serial 0042", false, true, 1.0, "0042"};
  EXPECT_EQ(armKey("wooden", wooden), "wooden:0042");
  EXPECT_EQ(armKey("wooden:0042", wooden), "wooden:0042");
  EXPECT_EQ(armKey("wooden:/dev/hidraw3", wooden), "wooden:0042");
  const servo::DeviceInfo touch{"Touch (vendor's driver)", false, true, 0.5, "41223700001"};
  EXPECT_EQ(armKey("openhaptics", touch), "openhaptics:41223700001");
}

TEST(ArmKey, OfAnArmWithoutASerialNumberIsItsName) {
  EXPECT_EQ(armKey("wooden:/dev/hidraw3", {"WoodenHaptics v1"}), "wooden:/dev/hidraw3");
  // What stands in a title is words.
  EXPECT_EQ(armKey("remote:10.0.0.7:7878", {"WoodenHaptics v1, serial 0042 at 10.0.0.7:7878, without force"}),
            "remote:10.0.0.7:7878");
  EXPECT_EQ(armKey("", {"Arm on a cable"}), "Arm on a cable");
  EXPECT_EQ(armKey("simulated", {"Simulated arm", true}), "simulated");
}

}  // namespace
}  // namespace underact::device
