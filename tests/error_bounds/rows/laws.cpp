#include <array>

#include "core/base/norms.h"
#include "core/control/law.h"
#include "core/control/passivity.h"
#include "tests/error_bounds/oracle/real.h"
#include "tests/error_bounds/rows/draws.h"
#include "tests/error_bounds/rows/rows.h"

namespace underact::error_bounds {
namespace laws_rows {

using control::LawInput;
using control::LawState;

/// Gains from 0 to 1e6, sometimes different for each axis.
Vec3 drawGains(Input& input, const char* name) {
  return input.vector(name, [](Dice& dice) {
    const auto one = [&] { return dice.one(6) ? 0.0 : std::min(dice.power(-20, 20), 1e6); };
    return dice.one(2) ? Vec3(Vec3::Constant(one())) : Vec3(one(), one(), one());
  });
}

Outcome judgeP(Input& input) {
  const control::P law{drawGains(input, "kp")};
  const Vec3 e_W =
      input.vector("e_W", [](Dice& dice) { return dice.oddPointAbout(Vec3::Zero(), Vec3::UnitX(), dice.scale()); });
  const Vec3 got = asTheServo([&] { return control::force(law, e_W); });
  double worst = 0.0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Real right = Real(law.kp_N_per_m[axis]) * e_W[axis];
    // A denormal error is zero to the servo, and its gain multiplies that: 1e6 of the least normal number.
    worst = std::max(worst, std::abs(e_W[axis]) < 0x1p-1022 ? (got[axis] == 0.0 ? 0.0 : kInfinity)
                                                            : ulpsOf(got[axis], right, Real(abs(right))));
  }
  return {worst, false};
}

/// Spring, damper and integral over a signal. The rate is the filter's (tested by itself); the integral is summed again
/// here, with its limits.
template <class Law>
Outcome judgeLaw(const Law& law, const Vec3& ki, double limit_N, const Signal& signal, Dice dice) {
  LawState state;
  std::array<Real, 3> integral{0, 0, 0}, moved{0, 0, 0};
  double worst = 0.0;
  for (std::size_t i = 0; i < signal.e_W.size(); ++i) {
    LawInput moment{signal.dt_s[i], dice.one(4), dice.one(40)};
    const Vec3& e_W = signal.e_W[i];
    const LawState before = state;
    Vec3 got = asTheServo([&] { return control::force(control::Law(law), state, e_W, moment); });
    const auto others = [&](Eigen::Index axis) {
      return Real(law.kp_N_per_m[axis]) * e_W[axis] + Real(law.kd_N_s_per_m[axis]) * state.velocity.rate_W[axis];
    };
    const auto sizeOf = [&](Eigen::Index axis) {
      return Real(abs(Real(law.kp_N_per_m[axis]) * e_W[axis]) +
                  abs(Real(law.kd_N_s_per_m[axis]) * state.velocity.rate_W[axis]));
    };
    // Where rounding decides the direction of the force, it also decides whether the integral grows: such a tick is not
    // limited.
    if (moment.limited) {
      bool unsure = false;
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<std::size_t>(axis);
        unsure = unsure || abs(others(axis) + integral[at]) <= ldexp(Real(sizeOf(axis) + moved[at]), -40);
      }
      if (unsure) {
        moment.limited = false;
        state = before;
        got = asTheServo([&] { return control::force(control::Law(law), state, e_W, moment); });
      }
    }
    Real squared = 0;
    for (std::size_t at = 0; at < 3; ++at) {
      const auto axis = static_cast<Eigen::Index>(at);
      const Real added = Real(ki[axis]) * e_W[axis] * moment.dt_s;
      const bool stops = moment.limited && added * (others(axis) + integral[at]) > 0;
      if (moment.idle || !(ki[axis] > 0.0)) {
        integral[at] = moved[at] = 0;
      } else if (!stops) {
        integral[at] += added;
        moved[at] += abs(added);
      }
      squared += integral[at] * integral[at];
    }
    if (sqrt(squared) > limit_N) {
      const Real keep = limit_N / sqrt(squared);
      for (Real& one : integral) one *= keep;
    }
    Real together = 0;  // the limit is common to all axes, so each one's rounding affects the others
    for (std::size_t at = 0; at < 3; ++at) together += moved[at];
    for (std::size_t at = 0; at < 3; ++at) {
      const auto axis = static_cast<Eigen::Index>(at);
      worst = std::max(worst, ulpsOf(got[axis], others(axis) + integral[at], sizeOf(axis) + together));
    }
  }
  return {worst, false};
}

control::Velocity drawVelocity(Input& input) {
  switch (input.choice("filter", 4)) {
    case 0:
      return control::LowPass{};
    case 1:
      return control::RawDifference{};
    case 2:
      return control::AdaptiveWindow{16, Vec3::Constant(1e-4)};
    default:
      return control::Kalman{1.6e-5, 8.0};
  }
}

Dice drawFlags(Input& input) {
  return Dice(static_cast<std::uint64_t>(
      input.number("flags", [](Dice& dice) { return static_cast<double>(dice.below(std::size_t{1} << 40U)); })));
}

Outcome judgePD(Input& input) {
  control::PD law{drawGains(input, "kp"), drawGains(input, "kd")};
  law.velocity = drawVelocity(input);
  const Signal signal = drawSignal(input, 40);
  return judgeLaw(law, Vec3::Zero(), 0.0, signal, drawFlags(input));
}

Outcome judgePID(Input& input) {
  control::PID law{drawGains(input, "kp"), drawGains(input, "kd"), drawGains(input, "ki")};
  law.integral_limit_N = input.number("limit_N", [](Dice& dice) { return dice.one(2) ? 0.88 : dice.scale(); });
  law.velocity = drawVelocity(input);
  const Signal signal = drawSignal(input, 40);
  return judgeLaw(law, law.ki_N_per_m_s, law.integral_limit_N, signal, drawFlags(input));
}

/// The energy of a constraint, summed as the observer's comment defines it.
Outcome judgePassivity(Input& input) {
  const Signal travel = drawSignal(input, 60), force = drawSignal(input, 60);
  Dice dice = drawFlags(input);
  double largest_N = 0.0;
  for (const Vec3& f_T_W : force.e_W) largest_N = std::max(largest_N, largestOf(f_T_W));
  control::EnergyState state;
  Real energy = 0, moved = 0, impulse_s = 0;
  std::array<Real, 3> impulse{0, 0, 0};
  struct Last {
    double stored_J = 0.0, level = 0.0;
    bool pulled = false, untouched = false, begun = false;
  } last;
  double worst = 0.0;
  for (std::size_t i = 1; i < travel.e_W.size(); ++i) {
    control::PassivityInput passage;
    passage.displacement_T_W = dice.one(4) ? Vec3(Vec3::Zero()) : Vec3(travel.e_W[i] - travel.e_W[i - 1]);
    passage.f_T_W = force.e_W[i];
    passage.e_W = travel.e_W[i];
    passage.stored_J = force.e_W[i].norm() * travel.e_W[i].norm();
    passage.level = dice.share();
    passage.dt_s = travel.dt_s[i];
    passage.pulls = !dice.one(8);
    passage.untouched = !passage.pulls && dice.one(2);
    passage.edited = dice.one(16);
    asTheServo([&] {
      observe(state, passage);
      remember(state, passage, passage.f_T_W);
      return 0;
    });
    Real taken = 0, sizes = 0;
    if (last.begun) {
      for (std::size_t at = 0; at < 3; ++at)
        impulse[at] += Real(passage.dt_s) * passage.f_T_W[static_cast<Eigen::Index>(at)];
      impulse_s += passage.dt_s;
      if (largestOf(passage.displacement_T_W) >= 0x1p-1022 && impulse_s > 0) {
        for (std::size_t at = 0; at < 3; ++at) {
          const Real part = impulse[at] / impulse_s * passage.displacement_T_W[static_cast<Eigen::Index>(at)];
          taken -= part;
          sizes += abs(part);
          impulse[at] = 0;
        }
        impulse_s = 0;
      }
    }
    const bool by_hand = passage.untouched || last.untouched;
    const bool handed_over = !last.begun || passage.edited || (last.pulled != passage.pulls && !by_hand);
    const Real ramped = (Real(passage.level) - last.level) * last.stored_J;
    const Real grown = Real(passage.level) * (Real(passage.stored_J) - last.stored_J);
    energy += taken + ramped + (handed_over ? grown : Real(0));
    moved += sizes + Real(last.stored_J) + (handed_over ? Real(passage.stored_J) : Real(0)) +
             Real(passage.displacement_T_W.cwiseAbs().sum()) * largest_N;
    last = {passage.stored_J, passage.level, passage.pulls, passage.untouched, true};
    worst = std::max(worst, ulpsOf(state.energy_J, energy, moved));
  }
  return {worst, false};
}

constexpr const char* kPromise = "ulp of kp |e| + kd |rate| and of all that the integral has moved";

constexpr std::array<Row, 4> kRows{{
    {"law_p", Kind::Law, "P: force, gains 0 to 1e6", "ulp of the force", 1, 1, judgeP},
    {"law_pd", Kind::Law, "PD over 40 samples, 1 Hz to 100 kHz, each filter", kPromise, 8, 5, judgePD},
    {"law_pid", Kind::Law, "PID over 40 samples, its limit and what stops it", kPromise, 64, 10, judgePID},
    {"law_passivity", Kind::Law, "Passivity observer over 60 ticks: energy", "ulp of all energies that it has added up",
     64, 4, judgePassivity},
}};

}  // namespace laws_rows

constinit const std::span<const Row> kLawRows = laws_rows::kRows;

}  // namespace underact::error_bounds
