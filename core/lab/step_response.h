#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "core/lab/arm_model.h"
#include "core/lab/sampled_response.h"
#include "core/lab/second_order_fit.h"
#include "core/scene/description.h"
#include "core/sim/arm_model.h"
#include "core/sim/hand.h"

namespace underact::lab {

/// x, y, z of W, or the direction in which the constraint pulls a tip that is a little off it.
enum class Axis : std::uint8_t { X, Y, Z, Held };

/// "x", "y", "z", "held".
const char* name(Axis axis);

/// How a step of the simulated arm is measured.
struct StepSetup {
  double step_m = 0.010;
  std::optional<Axis> axis = {};          // none: the first of them along which the constraint holds
  std::string constraint = {};            // by name; empty: the only one there is
  Vec3 from_W = Vec3(0.0, 0.0, 0.06);     // the tip rests at the target nearest to here before the step
  sim::ArmModel arm = {};                 // what the arm is made of
  sim::HandModel hand = {0.0, 0.0, 0.0};  // what stays on the stylus; by default nothing
  int rate_hz = 1000;
  double seconds = 0.0;  // after the step; 0: as long as the model asks for, 0.5 to 10, 20,000 ticks
  bool limits = true;    // the gate's; false: the law alone
};

/// A measured step of the simulated arm, beside the response of a mass held by the same law.
struct ArmStep {
  std::string constraint;
  scene::LawType law = scene::LawType::P;
  Axis axis = Axis::X;
  Vec3 along_W = Vec3::UnitX();  // the same as a direction, of length 1
  double step_m = 0.0;
  int rate_hz = 1000;
  Vec3 p_WBefore = Vec3::Zero();      // the target before the step
  SampledResponse travel_m;           // of the tip along it, as the encoders show it; the step is at 0
  StepMetrics measured;               // final value in m
  double steady_error_m = 0.0;        // from the target to where the tip ended, along it
  std::optional<SecondOrderFit> fit;  // gain and residual in m; none: the tip did not move
  HeldMass model;                     // what the arm is along it, by the simulation's own figures
  TransferFunction analytic;          // from the target's place to the tip's
  double friction_N = 0.0;
  std::int64_t limited_ticks = 0;  // in which the gate cut the force: the response is not a linear one
  double peak_force_N = 0.0;       // as sent
  std::string fault;               // that ended it early; empty: none
};

/// Lets the tip rest at the target until the force is ramped up (0.5 s), moves the target by the step between two ticks
/// (without the 60 ms over which the servo fades in an edit; a law's rate does not count the jump, as in eq. B.14), and
/// records the tip. Tick, gate and plant are those of a run, so the results are the same every time. Problems: those of
/// the scene; no such constraint, or several and none named; a wall; a target that is not unique, or that the arm does
/// not reach; a constraint that does not hold along the axis; neither mass nor damping. Cost: some 25 us a tick with
/// its fit, so half a second for 20,000.
Result<ArmStep> measureStep(const scene::Description& scene, const StepSetup& setup);

/// The scene with everything that holds the stylus moved by by_mm, in W, the joints of virtual robots included.
scene::Description withTargetsMoved(scene::Description scene, const Vec3& by_mm);

}  // namespace underact::lab
