#pragma once
#include <memory>
#include <span>
#include <string_view>

#include "core/arm/preset.h"
#include "core/base/result.h"
#include "core/servo/device_port.h"
#include "core/sim/arm_model.h"

namespace underact::device {

/// What is asked of any arm that is opened.
struct Request {
  arm::Preset arm;
  sim::ArmModel model;  // of a simulated one
  int rate_hz = 1000;
};

/// A kind of arm that a person can choose.
struct Row {
  const char* key;   // "simulated": what the command line takes
  const char* name;  // "Simulated arm": what the window shows
  /// The arm, open. Problems: why it cannot be, and what to do.
  Result<std::unique_ptr<servo::DevicePort>> (*open)(const Request& request);
};

std::span<const Row> catalogue();

/// The row of that key, or null.
const Row* findDevice(std::string_view key);

}  // namespace underact::device
