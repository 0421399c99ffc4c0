#pragma once
#include <memory>

#include "core/servo/host.h"
#include "device/simulated_arm.h"

namespace underact::gui {

/// A servo on the simulated arm, begun. arm is the host's own device: its hand can be moved for as long as the host
/// lives.
struct SimulatedHost {
  std::unique_ptr<servo::Host> host;
  device::SimulatedArm* arm = nullptr;
};

/// The arm of the thesis, held by the usual hand.
device::SimulatedArm::Options simulatedArmOptions(int rate_hz);

SimulatedHost makeSimulatedHost(const servo::HostOptions& options);

}  // namespace underact::gui
