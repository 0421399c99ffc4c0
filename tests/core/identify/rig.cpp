#include "tests/core/identify/rig.h"

#include <gtest/gtest.h>

#include <utility>

#include "core/arm/preset.h"
#include "device/measure_simulated.h"

namespace underact::identify::test {

sim::ArmModel armOf(double mass_kg, double friction_N, double damping_N_s_per_m) {
  sim::ArmModel model;
  model.mass_kg = mass_kg;
  model.friction_N = friction_N;
  model.damping_N_s_per_m = damping_N_s_per_m;
  return model;
}

Measured measured(const sim::ArmModel& model, const std::string& preset, int rate_hz, const Wanted& given) {
  Wanted wanted = given;
  wanted.arm_of.arm = preset;
  device::SimulatedArm::Options options;
  options.arm = *arm::findPreset(preset);
  options.model = model;
  options.rate_hz = rate_hz;
  auto done = device::measureSimulated(options, wanted, 1, {});
  EXPECT_TRUE(static_cast<bool>(done));
  EXPECT_EQ(done.value().fault.kind, FaultKind::None);
  return {std::move(done.value().plan), std::move(done.value().recorded)};
}

}  // namespace underact::identify::test
