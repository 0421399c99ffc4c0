#include "device/wooden_haptics/report.h"

#include <gtest/gtest.h>

#include <vector>

#include "device/wooden_haptics/kinematics.h"
#include "tests/support/property.h"

namespace underact::device {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes bytesOf(const WoodenMessage& message) {
  return {message.span().begin(), message.span().end()};
}

}  // namespace

TEST(WoodenReport, TheLengthTellsTheFormat) {
  EXPECT_EQ(formatOf(8)->protocol, WoodenProtocol::V1);
  EXPECT_EQ(formatOf(14)->protocol, WoodenProtocol::V2);
  EXPECT_EQ(formatOf(64)->protocol, WoodenProtocol::V2);
  for (const std::size_t bytes : std::initializer_list<std::size_t>{0, 7, 9, 13, 15, 63, 65})
    EXPECT_FALSE(formatOf(bytes)) << bytes;
}

TEST(WoodenReport, WordsAreSignedAndTheirLowByteIsFirst) {  // by hand
  const Bytes v1{0x01, 0x00, 0xFE, 0xFF, 0x00, 0x80, 0x34, 0x12};
  const auto report = readWoodenReport(kWoodenV1, v1);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->counts, (std::array<int, 3>{1, -2, -32768}));
  EXPECT_FALSE(report->button);
  EXPECT_FALSE(report->wants_calibration);
  EXPECT_FALSE(readWoodenReport(kWoodenV2, v1));
  EXPECT_FALSE(readWoodenReport(kWoodenV1, Bytes(7, 0)));
}

TEST(WoodenReport, AnEncoderDBeyond5000IsTheButton) {
  Bytes v2(14, 0);
  const auto withD = [&](int d) {
    v2[6] = static_cast<std::uint8_t>(d & 0xFF), v2[7] = static_cast<std::uint8_t>(d >> 8);
    return readWoodenReport(kWoodenV2, v2)->button;
  };
  EXPECT_FALSE(withD(0));
  EXPECT_FALSE(withD(5000));
  EXPECT_TRUE(withD(5001));
  EXPECT_TRUE(withD(10000));
  EXPECT_FALSE(readWoodenReport(kWoodenV2, v2)->wants_calibration);
  v2[12] = 1;
  EXPECT_TRUE(readWoodenReport(kWoodenV2, v2)->wants_calibration);
}

TEST(WoodenMessage, CurrentsComeAfterTheReportIdAndNothingElseDoes) {  // by hand
  EXPECT_EQ(bytesOf(currentsMessage(kWoodenV1, {1, -2, 2000})), (Bytes{0, 0x01, 0x00, 0xFE, 0xFF, 0xD0, 0x07, 0, 0}));
  const Bytes v2 = bytesOf(currentsMessage(kWoodenV2, {1, -2, 2000}));
  EXPECT_EQ(v2, (Bytes{0, 0x01, 0x00, 0xFE, 0xFF, 0xD0, 0x07, 0, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(bytesOf(currentsMessage(kWoodenTeensy, {1, -2, 2000})).size(), 65U);
}

TEST(WoodenMessage, ACalibrationSetsAToCInTheAttributesAndDToFInThePlaceOfCurrents) {  // by hand
  EXPECT_EQ(bytesOf(calibrationMessage(kWoodenV2, {1, 2, 6000, 4, 5, -6})),
            (Bytes{0, 4, 0, 5, 0, 0xFA, 0xFF, 1, 0, 1, 0, 2, 0, 0x70, 0x17}));
}

TEST(WoodenReport, WhateverComesIsRefusedOrASampleOfNumbers) {
  test::Random random(test::Seed{2018});
  for (int round = test::sweep(10'000, 100'000); round > 0; --round) {
    Bytes bytes(random.below(70));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.bits());
    for (const WoodenFormat& format : {kWoodenV1, kWoodenV2, kWoodenTeensy}) {
      const auto report = readWoodenReport(format, bytes);
      ASSERT_EQ(report.has_value(), bytes.size() == format.bytes);
      if (!report) continue;
      for (const WoodenModel& model : woodenModels()) {
        const WoodenWiring& wiring = woodenWiring(format.protocol);
        const arm::JointAngles q_rad = woodenJoints(model, wiring, report->counts);
        for (const double angle_rad : q_rad) ASSERT_TRUE(std::isfinite(angle_rad));
        for (const std::int16_t mA : woodenCurrents(model, wiring, q_rad, 1e6 * random.direction()))
          ASSERT_LE(std::abs(mA), kMaxCurrent_mA);
      }
    }
  }
}

}  // namespace underact::device
