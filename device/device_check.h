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

/// What was observed of an open arm that was read and given zero force: what neither the vendor's documents nor our
/// tests can say about the hardware.
struct DeviceCheck {
  servo::DeviceInfo info;
  std::vector<std::string> listing;  // what the arm reports about itself
  std::string scheduling;
  int rate_hz = 0;
  std::int64_t ticks = 0;
  std::int64_t without = 0;   // ticks without a sample
  std::int64_t repeated = 0;  // samples with bit-identical joints to the one before
  servo::Percentiles lateness;
  arm::JointAngles min_rad{}, largest_rad{};  // of each joint; 0 where no sample came
  Vec3 min_p_WT = Vec3::Zero(), largest_p_WT = Vec3::Zero();
  std::uint32_t buttons = 0;  // those seen pressed
  std::string trouble;        // what the arm's side says is wrong
};

/// Ticks an open arm for that long, without a scene and never started, so that it is sent zero force only. goes_on:
/// called now and then; false ends it early.
DeviceCheck checkDevice(std::unique_ptr<servo::DevicePort> arm, const arm::Preset& preset, int rate_hz, double seconds,
                        const std::function<bool()>& goes_on);

/// The report that a person sends: all of that, their own remarks (as typed), and the program's version.
std::string reportText(const DeviceCheck& trial, std::string_view name, std::string_view words);

}  // namespace underact::device
