#include "app/gui/simulated_host.h"

#include "core/arm/preset.h"
#include "core/sim/arm_model.h"

namespace underact::gui {

device::SimulatedArm::Options simulatedArmOptions(int rate_hz) {
  device::SimulatedArm::Options options;
  options.arm = *arm::findPreset(arm::kDefaultArm);
  options.model = *sim::findArmModel(sim::kDefaultArmModel);
  options.rate_hz = rate_hz;
  options.start_p_WT = {0.0, 0.0, 0.05};  // on the first start's sphere: it is there, and does not push yet
  return options;
}

SimulatedHost makeSimulatedHost(const servo::HostOptions& options) {
  auto device = std::make_unique<device::SimulatedArm>(simulatedArmOptions(options.rate_hz));
  device::SimulatedArm* arm = device.get();
  auto host = std::make_unique<servo::Host>(std::move(device), options);
  host->begin();
  return {std::move(host), arm};
}

}  // namespace underact::gui
