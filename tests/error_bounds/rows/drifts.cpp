#include <array>

#include "core/base/units.h"
#include "core/control/law.h"
#include "core/control/passivity.h"
#include "core/safety/gate.h"
#include "core/safety/stages.h"
#include "core/target/friction.h"
#include "tests/core/safety/pushed.h"
#include "tests/error_bounds/oracle/real.h"
#include "tests/error_bounds/rows/rows.h"

namespace underact::error_bounds {
namespace drifts_rows {

// Hours of simulated time. N additions may lose N half ulp of the largest sum; that is what is promised, so the unit of
// each row is N half ulp and its promise a few. A hundred digits are not needed here: 113 bits lose 2^-89 of it.
using Long = boost::multiprecision::cpp_bin_float_quad;

double drawTicks(Input& input) {
  return input.number("ticks", [](Dice&) { return 3.6e6; });  // an hour at 1 kHz; the long tests ask for four
}

double unitsOf(double got, const Long& right, const Long& largest, double ticks) {
  if (!std::isfinite(got)) return kInfinity;
  static const Long kHalfUlp = ldexp(Long(1), -53);
  return static_cast<double>(Long(abs(Long(got) - right) / (kHalfUlp * ticks * largest)));
}

/// The time without motion, as the gate sums it from the device's nanoseconds.
Outcome judgeTime(Input& input) {
  const double ticks = drawTicks(input);
  const auto period_ns = static_cast<std::int64_t>(
      input.number("period_ns", [](Dice& dice) { return std::floor(dice.between(2e5, 2e6)); }));
  safety::GateState state;
  safety::GateInput asked;
  asked.motion.moved = false;
  const safety::Limits limits{0.88};
  const double dt_s = kSecondPerNanosecond * static_cast<double>(period_ns);
  asTheServo([&] {
    for (double tick = 0; tick < ticks; ++tick) state = safety::gate(limits, state, asked, dt_s).next;
    return 0;
  });
  const Long right = Long(ticks) * period_ns / 1000000000;
  return {unitsOf(state.still_s, right, right, ticks), false};
}

Outcome judgeIntegral(Input& input) {
  const double ticks = drawTicks(input);
  const Vec3 ki = input.vector("ki", [](Dice& dice) { return Vec3(Vec3::Constant(dice.power(0, 20))); });
  const Vec3 size = input.vector("size_m", [](Dice& dice) {
    return Vec3{dice.power(-20, -8), dice.power(-20, -8), 1e-3};
  });
  const control::Law law = control::PID{Vec3::Zero(), Vec3::Zero(), ki, 1e300};
  control::LawState state;
  const FlushDenormals as_the_servo;
  std::array<Long, 3> sum{0, 0, 0}, largest{0, 0, 0};
  Dice dice(7);
  for (double tick = 0; tick < ticks; ++tick) {
    const Vec3 e_W = size.cwiseProduct(dice.inBox(1.0) + Vec3(0.0, 0.25, 1.0));
    const control::LawInput moment{1e-3, false, false};
    control::force(law, state, e_W, moment);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<Eigen::Index>(axis);
      sum[axis] += Long(ki[at]) * e_W[at] * 1e-3;
      largest[axis] = std::max(largest[axis], Long(abs(sum[axis])));
    }
  }
  double worst = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    worst =
        std::max(worst, unitsOf(state.integral_T_W[static_cast<Eigen::Index>(axis)], sum[axis], largest[axis], ticks));
  return {worst, false};
}

/// A spring that is pressed and released, again and again.
Outcome judgeEnergy(Input& input) {
  const double ticks = drawTicks(input);
  const double k = input.number("k", [](Dice& dice) { return dice.power(0, 20); });
  const double share = input.number("given_back", [](Dice& dice) { return dice.between(0.5, 1.5); });
  control::EnergyState state;
  const FlushDenormals as_the_servo;
  Long energy = 0, largest = 0;
  Vec3 last_W = Vec3::Zero();
  Dice dice(11);
  for (double tick = 0; tick < ticks; ++tick) {
    control::PassivityInput passage;
    const Vec3 e_W = 1e-3 * dice.inBox(1.0);
    passage.displacement_T_W = tick > 0 ? Vec3(last_W - e_W) : Vec3(Vec3::Zero());
    passage.e_W = e_W;
    passage.f_T_W = (share * k) * last_W;
    passage.level = 1.0;
    passage.dt_s = 1e-3;
    passage.pulls = true;
    passage.stored_J = 0.5 * k * e_W.squaredNorm();
    observe(state, passage);
    remember(state, passage, passage.f_T_W);
    if (tick > 0) {
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        energy -= Long(passage.f_T_W[axis]) * passage.displacement_T_W[axis];
    } else {
      energy += passage.stored_J;
    }
    largest = std::max(largest, Long(abs(energy)));
    last_W = e_W;
  }
  return {unitsOf(state.energy_J, energy, largest, ticks), false};
}

/// The low-pass has a finite memory, so errors accumulate only over its time constant.
Outcome judgeRate(Input& input) {
  const double ticks = drawTicks(input);
  const double tau_s = input.number("time_constant_s", [](Dice& dice) { return dice.power(-10, 3); });
  const double size = input.number("size_m", [](Dice& dice) { return dice.power(-20, 0); });
  const control::Velocity filter = control::LowPass{tau_s};
  control::VelocityState state;
  const FlushDenormals as_the_servo;
  Long rate = 0, fastest = 0;
  Vec3 last_W = Vec3::Zero();
  Dice dice(13);
  const Long share = Long(1e-3) / (Long(1e-3) + tau_s);
  for (double tick = 0; tick < ticks; ++tick) {
    const Vec3 e_W = size * dice.inBox(1.0);
    updateRate(filter, state, e_W, 1e-3);
    if (tick > 0) {
      const Long raw = (Long(e_W.x()) - last_W.x()) / Long(1e-3);
      rate += share * (raw - rate);
      fastest = std::max(fastest, Long(abs(raw)));
    }
    last_W = e_W;
  }
  return {unitsOf(state.rate_W.x(), rate, fastest, 1.0 + 1.0 / static_cast<double>(share)), false};
}

/// The same for a motor's heat, whose time constant is a minute: 60 000 ticks of memory.
Outcome judgeHeat(Input& input) {
  const double ticks = drawTicks(input);
  const double continuous_N_m = input.number("continuous_N_m", [](Dice& dice) { return dice.power(-10, 3); });
  safety::Thermal thermal;
  thermal.continuous_N_m = {continuous_N_m, continuous_N_m, continuous_N_m};
  const FlushDenormals as_the_servo;
  safety::Heat heat{};
  const safety::Motion motion = safety::threeJoints(Mat3::Identity());
  Long right = 0, largest = 0;
  Dice dice(17);
  const Long share = Long(1e-3) / Long(thermal.time_constant_s);
  for (double tick = 0; tick < ticks; ++tick) {
    const Vec3 f_T_W = (1.5 * continuous_N_m) * dice.inBox(1.0);
    heat = safety::heated(thermal, heat, motion, {f_T_W, Vec3::Zero()}, 1e-3);
    const Long load = Long(f_T_W.x()) / continuous_N_m;
    right += share * (load * load - right);
    largest = std::max(largest, right);
  }
  return {unitsOf(heat[0], right, largest, 1.0 + 1.0 / static_cast<double>(share)), false};
}

/// A grip that is dragged back and forth: it stays within its share of the surface's point, for any time.
Outcome judgeGrip(Input& input) {
  const double ticks = drawTicks(input);
  target::Friction friction;
  friction.static_share = friction.dynamic_share =
      input.number("share", [](Dice& dice) { return dice.between(0.05, 2.0); });
  const double size_m = input.number("size_m", [](Dice& dice) { return dice.power(-20, 0); });
  const FlushDenormals as_the_servo;
  target::Grip grip;
  std::array<Long, 2> right{0, 0};
  Vec3 p_WT = Vec3::Zero();
  Dice dice(19);
  for (double tick = 0; tick < ticks; ++tick) {
    if (dice.one(8)) p_WT = size_m * dice.inBox(1.0);  // between them it rests
    const Vec3 p_WP(p_WT.x(), p_WT.y(), size_m);
    const bool is_first = grip.hold == target::Hold::None;
    slides(friction, p_WT, p_WP, 1e-3, grip);
    const Long depth = Long(p_WP.z()) - p_WT.z(), held = Long(friction.static_share) * depth;
    const std::array<Long, 2> along{right[0] - p_WP.x(), right[1] - p_WP.y()};
    const Long squared = along[0] * along[0] + along[1] * along[1];
    if (is_first) {
      right = {p_WP.x(), p_WP.y()};
    } else if (squared > held * held) {
      const Long keep = held / sqrt(squared);
      right = {p_WP.x() + keep * along[0], p_WP.y() + keep * along[1]};
    }
  }
  return {std::max(unitsOf(grip.p_WG.x(), right[0], size_m, ticks), unitsOf(grip.p_WG.y(), right[1], size_m, ticks)),
          false};
}

// One case for each seed, whatever the count, as an hour is long.
constexpr int kOnce = 1'000'000'000;

constexpr std::array<Row, 6> kRows{{
    {"drift_time", Kind::Drift, "An hour at 0.5 to 5 kHz: time added up by the gate",
     "half ulp of the whole for each tick, and the period's own", 2, kOnce, judgeTime},
    {"drift_integral", Kind::Drift, "An hour at 1 kHz: integral of PID", "half ulp of the largest sum for each tick", 2,
     kOnce, judgeIntegral},
    {"drift_energy", Kind::Drift, "An hour at 1 kHz: energy of the passivity observer",
     "half ulp of the largest sum for each tick", 2, kOnce, judgeEnergy},
    {"drift_rate", Kind::Drift, "An hour at 1 kHz: low-pass",
     "half ulp of the fastest difference for each tick of memory", 4, kOnce, judgeRate},
    {"drift_heat", Kind::Drift, "An hour at 1 kHz: heat of a motor", "half ulp of the heat for each tick of memory", 4,
     kOnce, judgeHeat},
    {"drift_grip", Kind::Drift, "An hour at 1 kHz: the point at which friction holds",
     "half ulp of the motion for each tick", 1, kOnce, judgeGrip},
}};

}  // namespace drifts_rows

constinit const std::span<const Row> kDriftRows = drifts_rows::kRows;

}  // namespace underact::error_bounds
