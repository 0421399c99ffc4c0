#include "device/wooden_haptics/report.h"

namespace underact::device {
namespace {

// V2: positions of the values.
constexpr std::size_t kEncoderD = 3, kInfo = 6, kCommand = 3, kFirstAttribute = 4;
constexpr int kButtonFrom = 5000;
constexpr int kSetEncoders = 1, kWantsCalibration = 1;

int wordAt(std::span<const std::uint8_t> bytes, std::size_t word) {
  const unsigned value = bytes[2 * word] | static_cast<unsigned>(bytes[2 * word + 1]) << 8U;
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(value));
}

void setWord(WoodenMessage& message, std::size_t word, int value) {
  const auto bits = static_cast<std::uint16_t>(value);
  message.bytes[1 + 2 * word] = static_cast<std::uint8_t>(bits & 0xFFU);
  message.bytes[2 + 2 * word] = static_cast<std::uint8_t>(bits >> 8U);
}

}  // namespace

std::optional<WoodenFormat> formatOf(std::size_t bytes) {
  for (const WoodenFormat& format : {kWoodenV1, kWoodenV2, kWoodenTeensy}) {
    if (format.bytes == bytes) return format;
  }
  return {};
}

std::optional<WoodenReport> readWoodenReport(const WoodenFormat& format, std::span<const std::uint8_t> bytes) {
  if (bytes.size() != format.bytes) return {};
  WoodenReport report;
  report.counts = {wordAt(bytes, 0), wordAt(bytes, 1), wordAt(bytes, 2)};
  if (format.protocol == WoodenProtocol::V1) return report;
  report.button = wordAt(bytes, kEncoderD) > kButtonFrom;
  report.wants_calibration = wordAt(bytes, kInfo) == kWantsCalibration;
  return report;
}

WoodenMessage currentsMessage(const WoodenFormat& format, const Currents_mA& currents_mA) {
  WoodenMessage message;
  message.size = 1 + format.bytes;
  for (std::size_t motor = 0; motor < 3; ++motor) setWord(message, motor, currents_mA[motor]);
  return message;
}

WoodenMessage calibrationMessage(const WoodenFormat& format, const std::array<std::int16_t, 6>& counts) {
  WoodenMessage message;
  message.size = 1 + format.bytes;
  setWord(message, kCommand, kSetEncoders);
  for (std::size_t encoder = 0; encoder < 3; ++encoder) {
    setWord(message, kFirstAttribute + encoder, counts[encoder]);
    setWord(message, encoder, counts[3 + encoder]);  // d, e, f take the place of the currents
  }
  return message;
}

}  // namespace underact::device
