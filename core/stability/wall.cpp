#include "core/stability/wall.h"

#include "core/base/units.h"
#include "core/scene/description.h"

namespace underact::stability {

bool SampledWall::isLinear() const {
  return friction_N == 0.0 && coarseness == 0.0 && !std::holds_alternative<control::AdaptiveWindow>(velocity);
}

control::Velocity defaultKalman() {
  const scene::KalmanFilter default_value;
  return control::Kalman{kMetrePerMillimetre * default_value.noise_mm,
                         kMetrePerMillimetre * default_value.acceleration_mm_per_s2};
}

sim::Plant plantOf(const SampledWall& wall) {
  sim::ArmModel model;
  model.mass_kg = wall.mass_kg;
  model.friction_N = wall.friction_N;
  model.encoders = wall.coarseness > 0.0;
  sim::Plant plant = sim::makePlant(*arm::findPreset(arm::kDefaultArm), model,
                                    {0.0, wall.damping_N_s_per_m, wall.hand_stiffness_N_per_m});
  if (model.encoders) {
    for (double& counts : plant.arm.counts_per_turn) counts /= wall.coarseness;
  }
  return plant;
}

}  // namespace underact::stability
