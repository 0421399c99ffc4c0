#pragma once
#include <functional>

#include "core/base/fault.h"
#include "core/identify/measurement.h"
#include "device/simulated_arm.h"

namespace underact::device {

/// A measurement of a simulated arm: complete, or ended early by a fault.
struct SimulatedMeasurement {
  identify::Plan plan;
  std::vector<identify::Recorded> recorded;
  Fault fault;  // of the servo; not None: the recording is incomplete and tells nothing
};

/// Runs the plan on a simulated arm as fast as possible, with a simulated person at the stylus; the same numbers every
/// time. seed: of the tip's first rest position. progress: false cancels it. Problems: those of the plan; it was
/// cancelled.
Result<SimulatedMeasurement> measureSimulated(SimulatedArm::Options options, const identify::Wanted& wanted,
                                              std::uint64_t seed, const std::function<bool(double share)>& progress);

}  // namespace underact::device
