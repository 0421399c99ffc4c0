#pragma once
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/identify/body_fit.h"
#include "core/identify/encoder_steps.h"
#include "core/identify/measurement.h"
#include "core/identify/press.h"
#include "core/identify/weak_form.h"

namespace underact::identify {

/// The swings along one axis at one position, and the body fitted to them.
struct AxisSwings {
  std::size_t place = 0;
  int axis = 0;
  BodyFit fit;
  std::vector<Window> windows;
  std::optional<StiffnessFromSwing> stiffness;  // asked: kSwing_N_per_mm
};

/// The results for an arm.
struct Identified {
  std::string arm;  // preset
  int rate_hz = 0;
  std::vector<Vec3> places_W;
  std::vector<AxisSwings> swings;   // place by place, x, y, z
  std::array<Estimate, 3> mass_kg;  // along x, y, z, over all places
  std::array<Estimate, 3> friction_N;
  std::array<Estimate, 3> damping_N_s_per_m;
  Estimate mean_mass_kg, mean_friction_N, mean_damping_N_s_per_m;  // over all axes, as a model has them
  std::array<std::optional<Estimate>, 6> counts_per_turn;  // of the device: turret, thigh, shin from the base, gimbal
  Vec3 rest_noise_m = Vec3::Zero();
  Vec3 slow_noise_m = Vec3::Zero();
  std::optional<Press> press;  // asked: kPress_N_per_mm
  Problems notes;              // what could not be measured, and why
};

/// Evaluates a finished measurement. Problems: no result along some axis (without mass and friction there is none);
/// stopped. stop: asked often, true ends it early; may be empty. Cost: some 0.1 s for each position at 1 kHz.
Result<Identified> evaluate(const Plan& plan, const std::vector<Recorded>& recorded, int rate_hz,
                            const std::function<bool()>& stop = {});

/// The mean of several estimates, one at least. Each counts alike: weights by their variances, which are estimates
/// themselves, would favour those that seem more certain than they are. Where the estimates scatter by more than chance
/// explains, as those of a real arm may that differ from axis to axis, the uncertainty is that of their scatter.
Estimate meanOf(const std::vector<Estimate>& estimates);

}  // namespace underact::identify
