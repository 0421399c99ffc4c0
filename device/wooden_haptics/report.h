#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace underact::device {

// The messages between an open HID arm and the program: int16, little-endian, no report ids. Sources:
// WoodenHaptics/woody-experimental (V1, 2016), forsslund/haptikfabrikenapi (V2, 2018).

enum class WoodenProtocol : std::uint8_t {
  V1 = 1,  // counts of 3 encoders; 3 currents
  V2 = 2   // counts of 6 encoders, and whether the arm wants to be calibrated; 3 currents and a command
};

/// A protocol, and the length of its reports in both directions. The values come first, the rest is zero.
struct WoodenFormat {
  WoodenProtocol protocol = WoodenProtocol::V1;
  std::size_t bytes = 8;
};
inline constexpr WoodenFormat kWoodenV1{WoodenProtocol::V1, 8}, kWoodenV2{WoodenProtocol::V2, 14},
    kWoodenTeensy{WoodenProtocol::V2, 64};  // a Teensy's reports all have 64 bytes
inline constexpr std::size_t kLongestWoodenReport = 64;

/// The format whose reports have that many bytes.
std::optional<WoodenFormat> formatOf(std::size_t bytes);

/// A report of the arm.
struct WoodenReport {
  std::array<int, 3> counts{};  // of the encoders of bodies A, B and C
  bool button = false;          // V2: encoder d beyond 5000
  bool wants_calibration = false;
};

/// None if the number of bytes is not that of the format.
std::optional<WoodenReport> readWoodenReport(const WoodenFormat& format, std::span<const std::uint8_t> bytes);

using Currents_mA = std::array<std::int16_t, 3>;

/// A message to the arm, with the report id 0 first, which hidapi requires and does not send.
struct WoodenMessage {
  std::array<std::uint8_t, kLongestWoodenReport + 1> bytes{};
  std::size_t size = 0;
  std::span<const std::uint8_t> span() const { return {bytes.data(), size}; }
};
WoodenMessage currentsMessage(const WoodenFormat& format, const Currents_mA& currents_mA);

/// V2: sets the counts of encoders a to f for the present posture. The motors rest meanwhile.
WoodenMessage calibrationMessage(const WoodenFormat& format, const std::array<std::int16_t, 6>& counts);

}  // namespace underact::device
