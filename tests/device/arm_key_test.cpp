#include "device/arm_key.h"

#include <gtest/gtest.h>

namespace underact::device {
namespace {

TEST(ArmKey, IsKindAndSerialNumberWhereverItIsPluggedIn) {
  const servo::DeviceInfo wooden{"WoodenHaptics v1, serial 0042", false, true, 1.0};
  EXPECT_EQ(armKey("wooden", wooden, {}), "wooden:0042");
  EXPECT_EQ(armKey("wooden:0042", wooden, {}), "wooden:0042");
  EXPECT_EQ(armKey("wooden:/dev/hidraw3", wooden, {}), "wooden:0042");
  const servo::DeviceInfo touch{"Touch (vendor's driver)", false, true, 0.5};
  EXPECT_EQ(armKey("openhaptics", touch, {"Model: Touch", "Serial number: 41223700001"}), "openhaptics:41223700001");
}

TEST(ArmKey, OfAnArmWithoutASerialNumberIsItsName) {
  EXPECT_EQ(armKey("wooden:/dev/hidraw3", {"WoodenHaptics v1"}, {}), "wooden:/dev/hidraw3");
  EXPECT_EQ(armKey("remote:10.0.0.7:7878", {"Touch over the network"}, {}), "remote:10.0.0.7:7878");
  EXPECT_EQ(armKey("", {"Arm on a cable"}, {}), "Arm on a cable");
  EXPECT_EQ(armKey("simulated", {"Simulated arm", true}, {}), "simulated");
}

}  // namespace
}  // namespace underact::device
