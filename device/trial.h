#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/arm/preset.h"
#include "core/servo/histogram.h"
#include "core/servo/host.h"

namespace underact::device {

/// What was seen of an arm that was opened, read from and not pushed with: what its makers' words and our tests cannot
/// say of the hardware.
struct Trial {
  servo::DeviceInfo info;
  std::vector<std::string> listing;  // what the arm says of itself
  std::string scheduling;
  int rate_hz = 0;
  std::int64_t ticks = 0;
  std::int64_t without = 0;   // ticks for which no sample came
  std::int64_t repeated = 0;  // samples with the joints of the one before, to the bit
  servo::Percentiles lateness;
  arm::JointAngles least_rad{}, largest_rad{};  // of each joint; 0 where no sample came
  Vec3 least_p_WT = Vec3::Zero(), largest_p_WT = Vec3::Zero();
  std::uint32_t buttons = 0;  // that were seen pressed
  std::string trouble;        // what the arm's side says is wrong
};

/// Ticks an open arm for so long, without a scene and never started, so that all it is sent is zero force. goes_on:
/// asked now and then; false ends it early.
Trial tryOut(std::unique_ptr<servo::DevicePort> arm, const arm::Preset& preset, int rate_hz, double seconds,
             const std::function<bool()>& goes_on);

/// The report that a person sends: all of that, what they say of it (as they typed it), and the program's version.
std::string reportText(const Trial& trial, std::string_view name, std::string_view words);

}  // namespace underact::device
