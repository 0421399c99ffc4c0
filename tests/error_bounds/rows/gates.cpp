#include <array>

#include "core/base/norms.h"
#include "core/safety/gate.h"
#include "core/safety/stages.h"
#include "tests/core/safety/pushed.h"
#include "tests/error_bounds/oracle/real.h"
#include "tests/error_bounds/rows/draws.h"
#include "tests/error_bounds/rows/rows.h"

namespace underact::error_bounds {
namespace gates_rows {

using safety::Limits;

Outcome judgeClamp(Input& input) {
  const Vec3 f_T_W = input.vector("f_T_W", [](Dice& dice) {
    const double size = dice.one(2) ? dice.scale() : dice.power(-1060, 1022);
    return Vec3(dice.one(3)
                    ? Vec3(size * dice.direction())
                    : Vec3{size * dice.between(-1, 1), dice.scale() * dice.between(-1, 1), size * dice.closeness()});
  });
  const double max_N = input.number("max_force_N", [&](Dice& dice) {
    if (dice.one(2)) return std::clamp(dice.between(0.5, 2.0) * largestOf(f_T_W), 1e-12, 1e300);  // at the limit itself
    return dice.one(2) ? 0.88 : dice.scale();
  });
  const Vec3 got = asTheServo([&] { return safety::clampForce(f_T_W, max_N); });
  const Real size = norm(real(f_T_W));
  const Real3 right = size > max_N ? Real(max_N / size) * real(f_T_W) : real(f_T_W);
  const Real beyond = norm(real(got)) - max_N;
  return {std::max(ulpsOf(got, right, norm(right)), ulpsOf(beyond > 0 ? beyond : Real(0), max_N)), false};
}

Outcome judgeSlew(Input& input) {
  Limits limits;
  limits.max_slew_N_per_s = input.number("slew", [](Dice& dice) { return dice.scale(); });
  const double dt_s = input.number("dt_s", [](Dice& dice) { return dice.one(8) ? 0.0 : dice.power(-17, 0); });
  const double size = input.number("size", [](Dice& dice) { return dice.scale(); });
  const Vec3 last = input.vector("last_T_W", [&](Dice& dice) { return dice.inBox(size); });
  const Vec3 f_T_W = input.vector("f_T_W", [&](Dice& dice) {
    return dice.one(2) ? dice.inBox(size) : Vec3(last + size * dice.closeness() * dice.direction());
  });
  const Vec3 got = asTheServo([&] { return safety::limitSlew(limits, last, f_T_W, dt_s); });
  const Real3 heading = real(f_T_W) - real(last);
  const Real length = norm(heading), max = Real(limits.max_slew_N_per_s) * dt_s;
  const Real3 right = length > max ? real(last) + Real(max / length) * heading : real(f_T_W);
  return {ulpsOf(got, right, norm(real(last)) + std::min(length, max)), false};
}

Outcome judgeHeat(Input& input) {
  safety::Thermal thermal;
  const double continuous_N_m = input.number("continuous_N_m", [](Dice& dice) { return dice.scale(); });
  thermal.continuous_N_m = {continuous_N_m, continuous_N_m, continuous_N_m};
  thermal.time_constant_s = input.number("time_constant_s", [](Dice& dice) { return dice.scale(); });
  const double dt_s = input.number("dt_s", [](Dice& dice) { return dice.power(-17, 1); });
  const Vec3 heat = input.vector("heat", [](Dice& dice) { return Vec3(dice.inBox(1.0).cwiseAbs()); });
  const Mat3 J_p = input.matrix("J_p", [](Dice& dice) { return Mat3(0.2 * dice.turn()); });
  const Vec3 f_T_W = input.vector("f_T_W", [&](Dice& dice) { return dice.inBox(continuous_N_m * dice.power(-10, 6)); });
  const safety::Heat got = asTheServo([&] {
    return safety::heated(thermal, {heat.x(), heat.y(), heat.z()}, safety::threeJoints(J_p), {f_T_W, Vec3::Zero()},
                          dt_s);
  });
  double worst = 0.0;
  for (Eigen::Index motor = 0; motor < 3; ++motor) {
    const Real torque = dot(real(J_p.col(motor)), real(f_T_W)), continuous = continuous_N_m;
    const Real loads = (J_p.col(motor).cwiseAbs().dot(f_T_W.cwiseAbs())) / continuous, load = torque / continuous;
    const Real share = std::min(Real(1), Real(Real(dt_s) / thermal.time_constant_s));
    const Real right = heat[motor] + share * (load * load - heat[motor]);
    worst = std::max(worst, ulpsOf(got[static_cast<std::size_t>(motor)], right, heat[motor] + share * loads * loads));
  }
  return {worst, false};
}

Vec3 drawAny(Dice& dice) {
  Vec3 v = dice.inBox(dice.one(2) ? dice.scale() : 1.0);
  while (dice.one(3)) v[static_cast<Eigen::Index>(dice.below(3))] = drawOdd(dice);
  return v;
}

/// Any input of the gate, tick after tick: its output is finite and within its limit. Then Start is pressed, and it
/// continues like a new one.
Outcome judgeAny(Input& input) {
  Limits limits = safety::limitsForHands(
      input.number("max_force_N", [](Dice& dice) { return dice.one(2) ? 0.88 : dice.scale(); }), Vec3::Constant(0.1));
  Dice dice(static_cast<std::uint64_t>(
      input.number("ticks", [](Dice& drawn) { return static_cast<double>(drawn.below(std::size_t{1} << 40U)); })));
  const auto drawAsked = [&](bool any) {
    safety::GateInput asked;
    asked.engage = !dice.one(8);
    asked.late = dice.one(8);
    asked.motion.moved = !dice.one(8);
    asked.f_T_W = any ? drawAny(dice) : dice.inBox(1.0);
    asked.motion.v_WT = any ? drawAny(dice) : dice.inBox(0.1);
    asked.motion.count = 3;
    for (std::size_t joint = 0; joint < 3; ++joint)
      asked.motion.joints[joint] = {any ? drawAny(dice) : dice.inBox(0.2), Vec3::Zero(), kInfinity, kInfinity};
    if (dice.one(2)) {
      const Vec3 room_rad = any ? drawAny(dice) : Vec3(dice.inBox(1.0).cwiseAbs());
      for (std::size_t joint = 0; joint < 3; ++joint)
        asked.motion.joints[joint].room_below_rad = room_rad[static_cast<Eigen::Index>(joint)];
    }
    asked.restart = dice.one(4);
    return asked;
  };
  safety::GateState state;
  double worst = 0.0;
  const auto tick = [&](const safety::GateInput& asked, double dt_s, safety::GateState& at) {
    const safety::Gated gated = asTheServo([&] { return safety::gate(limits, at, asked, dt_s); });
    at = gated.next;
    const Vec3 f_T_W = gated.force.f_T_W();
    const Real beyond = norm(real(f_T_W)) - limits.max_force_N;
    const bool is_finite =
        f_T_W.allFinite() && at.v_WT.allFinite() && at.f_T_W.allFinite() &&
        std::all_of(at.heat.begin(), at.heat.end(), [](double heat) { return std::isfinite(heat); }) &&
        at.level >= 0.0 && at.level <= 1.0;
    worst = std::max(worst, is_finite ? ulpsOf(beyond > 0 ? beyond : Real(0), limits.max_force_N) : kInfinity);
    return f_T_W;
  };
  for (int i = 0; i < 12; ++i) {
    const double dt_s = dice.one(4) ? drawOdd(dice) : dice.power(-17, 0);
    tick(drawAsked(true), dt_s, state);
  }
  safety::GateState fresh;
  fresh.heat = state.heat;
  for (int i = 0; i < 4; ++i) {
    safety::GateInput asked = drawAsked(false);
    asked.restart = i == 0;
    if (tick(asked, 1e-3, state) != tick(asked, 1e-3, fresh)) return {kInfinity, false};
  }
  return {worst, false};
}

constexpr std::array<Row, 4> kRows{{
    {"gate_clamp", Kind::Gate, "Clamp, forces 1e-320 to 1e308: magnitude, and direction kept",
     "ulp of the force that is left, and of the greatest one", 4, 1, judgeClamp},
    {"gate_slew", Kind::Gate, "Slew limit: as far along the straight line as time allows",
     "ulp of the last force and of the change", 4, 1, judgeSlew},
    {"gate_heat", Kind::Gate, "Heat of a motor a tick later", "ulp of the heat and of what a tick can add", 8, 1,
     judgeHeat},
    {"gate_any", Kind::Gate, "Gate: NaN, infinities, denormals and 1e308 in every field for 12 ticks, then Start",
     "ulp of the greatest force beyond it; finite always; after Start the bits of a new gate", 4, 2, judgeAny},
}};

}  // namespace gates_rows

constinit const std::span<const Row> kGateRows = gates_rows::kRows;

}  // namespace underact::error_bounds
