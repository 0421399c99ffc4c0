#pragma once
#include <memory>

#include "core/servo/host.h"
#include "device/chosen_arm.h"
#include "device/replayed_arm.h"
#include "device/simulated_arm.h"

namespace underact::gui {

/// A running servo on the simulated arm, with the chosen arm and the replayed arm in front of it. The host owns them
/// all: the hand can be moved, other arms chosen and recordings replayed as long as the host lives.
struct SimulatedHost {
  std::unique_ptr<servo::Host> host;
  device::SimulatedArm* arm = nullptr;
  device::ReplayedArm* replay = nullptr;
  device::ChosenArm* chosen = nullptr;
};

/// The arm of the thesis, held by the usual hand.
device::SimulatedArm::Options simulatedArmOptions(int rate_hz);

SimulatedHost makeSimulatedHost(const servo::HostOptions& options);

}  // namespace underact::gui
