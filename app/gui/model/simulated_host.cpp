#include "app/gui/model/simulated_host.h"

#include "core/arm/preset.h"
#include "core/sim/arm_model.h"

namespace underact::gui {

device::SimulatedArm::Options simulatedArmOptions(int rate_hz) {
  device::SimulatedArm::Options options;
  options.arm = *arm::findPreset(arm::kDefaultArm);
  options.model = *sim::findArmModel(sim::kDefaultArmModel);
  options.rate_hz = rate_hz;
  options.start_p_WT = device::kFirst_p_WT;
  return options;
}

SimulatedHost makeSimulatedHost(const servo::HostOptions& options) {
  auto simulated = std::make_unique<device::SimulatedArm>(simulatedArmOptions(options.rate_hz));
  device::SimulatedArm* const arm = simulated.get();
  auto chosen = std::make_unique<device::ChosenArm>(std::move(simulated));
  device::ChosenArm* const choice = chosen.get();
  auto replayed = std::make_unique<device::ReplayedArm>(std::move(chosen), options.rate_hz);
  device::ReplayedArm* const replay = replayed.get();
  auto host = std::make_unique<servo::Host>(std::move(replayed), options);
  host->begin();
  return {std::move(host), arm, replay, choice};
}

}  // namespace underact::gui
