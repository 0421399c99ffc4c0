#pragma once
#include <functional>

#include "core/base/fault.h"
#include "core/identify/measurement.h"
#include "device/simulated_arm.h"

namespace underact::device {

/// A measurement of a simulated arm: done, or ended early by a fault.
struct SimulatedMeasurement {
  identify::Plan plan;
  std::vector<identify::Recorded> recorded;
  Fault fault;  // of the servo; not None: what was recorded is a part, and tells nothing
};

/// Runs the plan on a simulated arm as fast as it goes, with a simulated person at the stylus; the same numbers every
/// time. seed: of where the tip rests first. progress: false ends it. Problems: of the plan; it was ended.
Result<SimulatedMeasurement> measureSimulated(SimulatedArm::Options options, const identify::Wanted& wanted,
                                              std::uint64_t seed, const std::function<bool(double share)>& progress);

}  // namespace underact::device
