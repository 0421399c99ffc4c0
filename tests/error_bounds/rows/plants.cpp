#include <array>

#include "core/base/norms.h"
#include "core/base/units.h"
#include "core/sim/plant.h"
#include "tests/error_bounds/oracle/real.h"
#include "tests/error_bounds/rows/rows.h"

namespace underact::error_bounds {
namespace plants_rows {

using sim::Plant;
using sim::PlantState;

/// An arm without stops, of any mass.
Plant drawPlant(Input& input) {
  Plant plant;
  plant.arm = *arm::findPreset(arm::kDefaultArm);
  plant.arm.limits = arm::kNoJointLimits;
  plant.model.encoders = false;
  plant.model.mass_kg = input.number("mass_kg", [](Dice& dice) { return dice.one(2) ? 0.045 : dice.power(-20, 20); });
  return plant;
}

const Vec3 kMiddle{0.0, 0.0, 0.03};  // of the workspace: 50 mm each way are within reach

/// Free motion under a constant force: x + v t + f t^2 / 2 m.
Outcome judgeFlight(Input& input) {
  Plant plant = drawPlant(input);
  plant.hand = {0.0, 0.0, 0.0};
  plant.integration.integrator = input.flag("trapezoidal") ? Integrator::Trapezoidal : Integrator::MeanVelocity;
  const auto substeps = static_cast<int>(1 + input.choice("substeps", 400));
  plant.integration.substep_ns = static_cast<std::int64_t>(
      input.number("substep_ns", [](Dice& dice) { return std::floor(std::min(dice.power(7, 27), 1e8)); }));
  const double time_s = 1e-9 * static_cast<double>(plant.integration.substep_ns) * substeps;
  PlantState state = sim::restingState(plant, kMiddle);
  const Vec3 v_WT = input.vector("v_WT", [&](Dice& dice) { return dice.inBox(0.02 / time_s * dice.share()); });
  const Vec3 f_T_W = input.vector(
      "f_T_W", [&](Dice& dice) { return dice.inBox(0.04 * plant.model.mass_kg / (time_s * time_s) * dice.share()); });
  state.v_WT = v_WT;
  const Real3 p = real(state.p_WT), v = real(v_WT), f = real(f_T_W);
  state = asTheServo([&] { return sim::advance(plant, state, f_T_W, {}, plant.integration.substep_ns * substeps); });
  const Real t = Real(substeps) * plant.integration.substep_ns / 1000000000, pushed = t / Real(plant.model.mass_kg);
  const Real3 right_v = v + pushed * f, right_p = p + t * v + Real(t * pushed / 2) * f;
  const Real each = Real(substeps), fast = norm(v) + norm(f) * pushed;
  return {std::max(ulpsOf(state.v_WT, right_v, each * fast),
                   ulpsOf(state.p_WT, right_p, each * (largestOf(kMiddle) + fast * t))),
          false};
}

/// One substep: the residual of the momentum equation for its result, with any dampers, springs and friction.
Outcome judgeSubstep(Input& input) {
  Plant plant = drawPlant(input);
  const auto draw = [](Dice& dice) { return dice.one(4) ? 0.0 : dice.power(-20, 20); };
  plant.hand.mass_kg = input.number("hand_kg", draw);
  plant.hand.damping_N_s_per_m = input.number("b", draw);
  plant.hand.stiffness_N_per_m = input.number("k", draw);
  plant.model.friction_N = input.number("friction_N", draw);
  plant.model.damping_N_s_per_m = input.number("own_b", draw);
  constexpr std::array<Integrator, 3> kWhich{Integrator::MeanVelocity, Integrator::EndVelocity,
                                             Integrator::Trapezoidal};
  plant.integration.integrator = kWhich[input.choice("integrator", kWhich.size())];
  plant.integration.substep_ns = static_cast<std::int64_t>(
      input.number("substep_ns", [](Dice& dice) { return std::floor(std::min(dice.power(7, 27), 1e8)); }));
  const double dt_s = kSecondPerNanosecond * static_cast<double>(plant.integration.substep_ns);
  PlantState state = sim::restingState(plant, kMiddle);
  state.v_WT = input.vector("v_WT", [&](Dice& dice) { return dice.inBox(0.01 / dt_s * dice.share()); });
  const double mass_kg = plant.model.mass_kg + plant.hand.mass_kg;
  const Vec3 f_T_W =
      input.vector("f_T_W", [&](Dice& dice) { return dice.inBox(0.01 * mass_kg / (dt_s * dt_s) * dice.share()); });
  sim::HandSetpoint setpoint;
  setpoint.p_WT = input.vector("wish", [](Dice& dice) { return Vec3(kMiddle + dice.inBox(0.01)); });
  setpoint.v_WT = input.vector("wish_v", [&](Dice& dice) { return dice.inBox(0.01 / dt_s * dice.share()); });
  const PlantState before = state;
  state = asTheServo([&] { return sim::advance(plant, state, f_T_W, setpoint, plant.integration.substep_ns); });
  if (!state.p_WT.allFinite() || !state.v_WT.allFinite()) return {kInfinity, false};
  const bool ends = plant.integration.integrator == Integrator::EndVelocity;
  const bool halves = plant.integration.integrator == Integrator::Trapezoidal;
  const Real t = Real(plant.integration.substep_ns) / 1000000000, w = ends ? Real(0) : Real(0.5),
             d = halves ? Real(0.5) : Real(0);
  const Real3 x = real(before.p_WT), v = real(before.v_WT), v2 = real(state.v_WT),
              heading = t * (w * v + Real(1 - w) * v2);
  if (norm(real(state.p_WT) - real(kMiddle)) > Real(0.05)) return {0.0, true};  // outside the region that is tested
  const Real b = plant.hand.damping_N_s_per_m, own = plant.model.damping_N_s_per_m, k = plant.hand.stiffness_N_per_m;
  // v_w is constant; the spring is evaluated at the end, or (trapezoidal) in the middle of displacement and wish.
  const Real3 spring_at = halves ? x + Real(0.5) * heading : x + heading;
  const Real3 meant = real(setpoint.p_WT) - Real(d * t) * real(setpoint.v_WT), mean_v = d * v + Real(1 - d) * v2;
  const Real3 pushed = t * (real(f_T_W) - own * mean_v + b * (real(setpoint.v_WT) - mean_v) + k * (meant - spring_at));
  const Real3 friction_change = pushed - Real(mass_kg) * (v2 - v);  // the impulse of friction
  const Real max = t * plant.model.friction_N, taken = norm(friction_change);
  const Real size = t * norm(real(f_T_W)) + t * (own + b) * (norm(v) + norm(v2) + norm(real(setpoint.v_WT))) +
                    t * k * (norm(meant) + norm(x) + norm(heading)) + Real(mass_kg) * (norm(v) + norm(v2)) + max;
  double worst = ulpsOf(state.p_WT, x + heading, norm(x) + norm(t * v) + norm(t * v2));
  if (norm(v2) == 0) return {std::max(worst, ulpsOf(taken > max ? Real(taken - max) : Real(0), size)), false};
  const Real3 against = friction_change - Real(max / norm(v2)) * v2;
  worst = std::max(worst, ulpsOf(norm(against), size));
  return {worst, false};
}

constexpr std::array<Row, 2> kRows{{
    {"plant_flight", Kind::Plant, "Simulated arm in free flight under a held force, 1 to 400 substeps",
     "ulp of distance and speed for each substep", 4, 1, judgeFlight},
    {"plant_substep", Kind::Plant, "Simulated arm, one substep of any integrator, dampers, spring, friction",
     "ulp of all impulses: what is left of the momentum equation", 64, 2, judgeSubstep},
}};

}  // namespace plants_rows

constinit const std::span<const Row> kPlantRows = plants_rows::kRows;

}  // namespace underact::error_bounds
