#include "device/input/space_mouse.h"

#include <gtest/gtest.h>

#include <vector>

#include "device/input/default_maps.h"

namespace underact::device::input {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::vector<double> axesOf(const Readings& readings) {
  return {readings.axis.begin(), readings.axis.begin() + 6};
}

}  // namespace

TEST(SpaceMouseReport, ShiftAndTurnComeOneAfterTheOther) {  // a SpaceNavigator; by hand: 0x015E is 350
  Readings readings;
  EXPECT_EQ(readSpaceMouseReport(Bytes{1, 0x5E, 0x01, 0x51, 0xFF, 0x00, 0x00}, readings), SpaceMouseReport::Moved);
  EXPECT_EQ(axesOf(readings), (std::vector<double>{1.0, -0.5, 0.0, 0.0, 0.0, 0.0}));
  EXPECT_EQ(readSpaceMouseReport(Bytes{2, 0x23, 0x00, 0xDD, 0xFF, 0xF4, 0x01}, readings), SpaceMouseReport::Moved);
  EXPECT_EQ(axesOf(readings), (std::vector<double>{1.0, -0.5, 0.0, 0.1, -0.1, 1.0}));  // 500 is as far as 350
}

TEST(SpaceMouseReport, TwelveBytesAreBoth) {
  Readings readings;
  const Bytes report{1, 0x5E, 0x01, 0, 0, 0xA2, 0xFE, 0x23, 0x00, 0, 0, 0x00, 0x80};
  EXPECT_EQ(readSpaceMouseReport(report, readings), SpaceMouseReport::Moved);
  EXPECT_EQ(axesOf(readings), (std::vector<double>{1.0, 0.0, -1.0, 0.1, 0.0, -1.0}));
}

TEST(SpaceMouseReport, ButtonsAreBitsAndLeaveTheAxes) {
  Readings readings;
  readings.axis[2] = 0.7;
  EXPECT_EQ(readSpaceMouseReport(Bytes{3, 0x02}, readings), SpaceMouseReport::Buttons);
  EXPECT_EQ(readings.pressed, 2U);
  EXPECT_EQ(readSpaceMouseReport(Bytes{3, 0x00, 0x00, 0x40, 0x01}, readings), SpaceMouseReport::Buttons);
  EXPECT_EQ(readings.pressed, std::uint64_t{1} << 22U | std::uint64_t{1} << 24U);
  EXPECT_EQ(readSpaceMouseReport(Bytes{3}, readings), SpaceMouseReport::Buttons);
  EXPECT_EQ(readings.pressed, 0U);
  EXPECT_EQ(readings.axis[2], 0.7);
}

TEST(SpaceMouseReport, IgnoresReportsThatAreTooShortOrUnknown) {
  Readings readings;
  readings.axis[0] = 0.3;
  for (const Bytes& report : {Bytes{}, Bytes{1}, Bytes{1, 2, 3, 4, 5, 6}, Bytes{2, 1, 1, 1, 1, 1}, Bytes{0x17, 80},
                              Bytes{4, 1, 1, 1, 1, 1, 1, 1}, Bytes(64, 0)}) {
    EXPECT_EQ(readSpaceMouseReport(report, readings), SpaceMouseReport::Other);
  }
  EXPECT_EQ(axesOf(readings), (std::vector<double>{0.3, 0, 0, 0, 0, 0}));
}

TEST(SpaceMouseModels, EachIsThereOnceAndItsOtherInterfacesAreNone) {
  EXPECT_EQ(spaceMouseModels().size(), 21U);  // facts on devices, 3.3
  for (const SpaceMouseModel& model : spaceMouseModels()) {
    EXPECT_EQ(findSpaceMouse(model.vendor, model.product), &model) << model.name;
    EXPECT_LE(model.buttons.size(), static_cast<std::size_t>(kMaxButtons));
    EXPECT_TRUE(isSpaceMouse({model.vendor, model.product, 1, 8, "", ""}));
    EXPECT_TRUE(isSpaceMouse({model.vendor, model.product, 0, 0, "", ""}));   // not known, as long as it is closed
    EXPECT_FALSE(isSpaceMouse({model.vendor, model.product, 1, 2, "", ""}));  // a mouse at the same receiver
  }
  for (const int product : {0xC641, 0xC650, 0xC664, 0xC62C})  // refused, or not 3D mice
    EXPECT_EQ(findSpaceMouse(0x256F, static_cast<std::uint16_t>(product)), nullptr);
  EXPECT_EQ(escButton(*findSpaceMouse(0x046D, 0xC626)), -1);
  EXPECT_EQ(escButton(*findSpaceMouse(0x256F, 0xC633)), 22);
  EXPECT_EQ(escButton(*findSpaceMouse(0x046D, 0xC629)), 22);
  EXPECT_EQ(escButton(*findSpaceMouse(0x046D, 0xC625)), 10);
  EXPECT_EQ(escButton(*findSpaceMouse(0x046D, 0xC627)), 6);
}

TEST(SpaceMouseModels, GlfwsNameOfOneIsKnown) {
  EXPECT_TRUE(isSpaceMouseGuid("030000006d04000026c6000010010000"));
  EXPECT_FALSE(isSpaceMouseGuid("030000005e0400008e02000010010000"));  // an Xbox 360 controller
  for (const char* guid : {"", "03", "030000006d04000026", "zzzzzzzzzzzzzzzzzzzzzzzzzzzz"})
    EXPECT_FALSE(isSpaceMouseGuid(guid));
}

TEST(SpaceMouseModels, TheCapMovesTheStylusAsItIsMoved) {
  DeviceState seen;
  describeSpaceMouse(seen, -1);
  const ReadyAxes awake{{true, true, true, true, true, true}};
  const auto motion = [&](std::vector<double> values) {
    Readings readings;
    readings.axes = 6;
    std::copy(values.begin(), values.end(), readings.axis.begin());
    return motionOf(seen.default_value, readings, awake);
  };
  EXPECT_GT(motion({1, 0, 0, 0, 0, 0}).v_WT.x(), 0.1);
  EXPECT_GT(motion({0, 1, 0, 0, 0, 0}).v_WT.z(), 0.1);   // towards the person
  EXPECT_LT(motion({0, 0, 1, 0, 0, 0}).v_WT.y(), -0.1);  // down
  // The same rotation from HID's frame into W's: both are right-handed.
  EXPECT_GT(motion({0, 0, 0, 1, 0, 0}).w_WT_W.x(), 1.0);
  EXPECT_GT(motion({0, 0, 0, 0, 1, 0}).w_WT_W.z(), 1.0);
  EXPECT_LT(motion({0, 0, 0, 0, 0, 1}).w_WT_W.y(), -1.0);
}

}  // namespace underact::device::input
