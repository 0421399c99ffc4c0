#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/arm/preset.h"
#include "core/registration/fit.h"
#include "core/servo/device_port.h"

namespace underact::device {

/// Dialogue with the person at the arm.
struct TouchPrompts {
  std::function<void(const std::string& sentence)> say;  // what to do next
  std::function<bool()> goes_on;                         // called now and then; false ends it
  double wait_s = 120.0;                                 // for each press
};

/// An arm whose tip touches the reference points one after the other, held by a person who presses the stylus's button;
/// it is never started, so it is sent zero force only. port: open. Problems: the arm's trouble; nobody pressed; it was
/// ended.
Result<std::vector<registration::Touch>> touchReferencePoints(std::unique_ptr<servo::DevicePort> port,
                                                              const arm::Preset& preset, int rate_hz,
                                                              const std::vector<Vec3>& points_D,
                                                              const TouchPrompts& talk);

}  // namespace underact::device
