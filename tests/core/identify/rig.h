#pragma once
#include <string>

#include "core/identify/identified.h"
#include "core/sim/arm_model.h"

namespace underact::identify::test {

/// A measurement that is done, and what it was run with.
struct Measured {
  Plan plan;
  std::vector<Recorded> recorded;
};

/// An arm made of these figures.
sim::ArmModel armOf(double mass_kg, double friction_N, double damping_N_s_per_m);

/// Runs the whole plan on a simulated arm, by count of ticks, with a simulated person.
Measured measured(const sim::ArmModel& model, const std::string& preset, int rate_hz, const Wanted& wanted = {});

}  // namespace underact::identify::test
