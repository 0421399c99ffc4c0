#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace underact::device {

// What an open HID arm and the program say to each other: int16, little-endian, no report ids. Sources:
// WoodenHaptics/woody-experimental (V1, 2016), forsslund/haptikfabrikenapi (V2, 2018).

enum class WoodenProtocol : std::uint8_t {
  V1 = 1,  // counts of 3 encoders; 3 currents
  V2 = 2   // counts of 6 encoders, and whether the arm wants to be calibrated; 3 currents and a command
};

/// A protocol, and how long its reports are in both directions. The words stand first, the rest is zero.
struct WoodenFormat {
  WoodenProtocol protocol = WoodenProtocol::V1;
  std::size_t bytes = 8;
};
inline constexpr WoodenFormat kWoodenV1{WoodenProtocol::V1, 8}, kWoodenV2{WoodenProtocol::V2, 14},
    kWoodenTeensy{WoodenProtocol::V2, 64};  // a Teensy's reports all have 64 bytes
inline constexpr std::size_t kLongestWoodenReport = 64;

/// The format whose reports have so many bytes.
std::optional<WoodenFormat> formatOf(std::size_t bytes);

/// What an arm says.
struct WoodenReport {
  std::array<int, 3> counts{};  // of the encoders of bodies A, B and C
  bool button = false;          // V2: encoder d beyond 5000
  bool wants_calibration = false;
};

/// None where there are not as many bytes as the format has.
std::optional<WoodenReport> readWoodenReport(const WoodenFormat& format, std::span<const std::uint8_t> bytes);

using Currents_mA = std::array<std::int16_t, 3>;

/// A message to the arm, with the report id 0 first, which hidapi wants and the arm does not get.
struct WoodenMessage {
  std::array<std::uint8_t, kLongestWoodenReport + 1> bytes{};
  std::size_t size = 0;
  std::span<const std::uint8_t> span() const { return {bytes.data(), size}; }
};
WoodenMessage currentsMessage(const WoodenFormat& format, const Currents_mA& currents_mA);

/// V2: "in the posture that you have now your encoders a to f stand at". The motors rest meanwhile.
WoodenMessage calibrationMessage(const WoodenFormat& format, const std::array<std::int16_t, 6>& counts);

}  // namespace underact::device
