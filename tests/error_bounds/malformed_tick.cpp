#include "tests/error_bounds/malformed_tick.h"

#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "core/base/denormals.h"
#include "core/base/trig.h"
#include "tests/error_bounds/rows/draws.h"

namespace underact::error_bounds {
namespace {

constexpr std::int64_t kPeriod_ns = 1'000'000;
constexpr int kBefore = 30, kAfter = 60;

/// A motion through the workspace, with a rotation of the stylus.
arm::JointAngles anglesAt(std::int64_t tick, double phase) {
  const double t_s = 1e-3 * static_cast<double>(tick);
  return {0.35 * sinCos(1.7 * t_s + phase).sin, 0.6 + 0.35 * sinCos(2.3 * t_s + 1.0).sin,
          0.1 + 0.4 * sinCos(3.1 * t_s).cos,    1.0 * sinCos(0.9 * t_s).sin,
          1.5 + 0.5 * sinCos(1.1 * t_s).cos,    0.7 * sinCos(1.3 * t_s).sin};
}

std::int64_t drawTime(Input& input, std::int64_t now_ns) {
  constexpr std::array<std::int64_t, 9> kTimes{std::numeric_limits<std::int64_t>::min(),
                                               std::numeric_limits<std::int64_t>::max(),
                                               0,
                                               -1,
                                               1,
                                               1'000'000'000'000,
                                               -1'000'000'000'000,
                                               std::int64_t{1} << 53,
                                               99'999'999};
  const std::size_t which = input.choice("time", kTimes.size() + 3);
  if (which < kTimes.size()) return kTimes[which];
  return which == kTimes.size() ? now_ns : which == kTimes.size() + 1 ? now_ns + 1 : now_ns - 1;
}

/// Replaces a tick's input by one that no arm sends.
void spoil(Input& input, tick::TickInput& at) {
  const std::size_t field = input.choice("field", 10);  // an angle, all angles, the time, a fault, no sample
  const auto odd = [&] { return input.number("odd", drawOdd); };
  if (field < 6) at.sample.q_rad[field] = odd();
  if (field == 6) {
    for (double& angle_rad : std::span(at.sample.q_rad).first<6>()) angle_rad = odd();
  }
  if (field == 7) at.sample.time_ns = drawTime(input, at.sample.time_ns);
  if (field == 8) {
    at.fault.kind = static_cast<FaultKind>(input.choice("fault", kFaultKinds));
    at.fault.seen = odd();
  }
  if (field == 9) at.has_sample = false;
}

struct Run {
  const tick::TickProgram& program;
  tick::TickState state;
  std::unique_ptr<tick::TickReport> report = std::make_unique<tick::TickReport>();

  void feed(const tick::TickInput& input) {
    const FlushDenormals as_the_servo;
    step(program, input, state, *report);
  }
};

/// The excess over the greatest force in ulp; infinite where the force is not finite, or not zero although it should
/// be.
double forceError(const Run& run) {
  const Vec3& f_T_W = run.report->force.f_T_W();
  const double max_N = run.program.limits.max_force_N, size_N = f_T_W.norm();
  if (!f_T_W.allFinite()) return kInfinity;
  if (run.report->fault.kind != FaultKind::None && size_N > 0.0) return kInfinity;
  return size_N > max_N ? (size_N - max_N) / (0x1p-52 * max_N) : 0.0;
}

bool areFinite(std::initializer_list<Vec3> all) {
  for (const Vec3& one : all) {
    if (!one.allFinite()) return false;
  }
  return true;
}

bool isAllFinite(const control::VelocityState& velocity) {
  for (const control::Window::Row& row : velocity.window.e_W) {
    for (const double e : row) {
      if (!std::isfinite(e)) return false;
    }
  }
  const Vec3 spread(velocity.spread[0], velocity.spread[1], velocity.spread[2]);
  return areFinite({velocity.e_last_W, velocity.rate_W, velocity.place_W, spread});
}

bool isAllFinite(const std::array<double, manipulator::kMaxJoints>& values) {
  for (const double value : values) {
    if (!std::isfinite(value)) return false;
  }
  return true;
}

bool isAllFinite(const target::State& state) {
  bool all = state.grip.p_WG.allFinite();
  if (const auto* one = std::get_if<target::InfluenceState>(&state.memory))
    all = all && std::isfinite(one->delta_rad) && areFinite({one->about_W, one->n_W});
  if (const auto* robot = std::get_if<manipulator::State>(&state.memory))
    all = all && isAllFinite(robot->theta) && isAllFinite(robot->pace) && robot->p_WP.allFinite() &&
          isAllFinite(robot->background.theta);
  if (const auto* mesh = std::get_if<target::MeshState>(&state.memory)) all = all && mesh->touch.q_M.allFinite();
  return all;
}

bool isAllFinite(const tick::EntryState& entry) {
  const control::EnergyState& energy = entry.energy;
  bool all = isAllFinite(entry.target) && isAllFinite(entry.law.velocity) &&
             areFinite({entry.law.integral_T_W,
                        energy.e_last_W,
                        energy.f_T_W,
                        energy.impulse_N_s,
                        energy.displacement_T_W,
                        energy.change_W,
                        {energy.energy_J, energy.balance_J, energy.stored_J}});
  for (const double angle_rad : entry.follower.q_rad) all = all && std::isfinite(angle_rad);
  return all;
}

/// Whether force, target and fault are identical, to the bit.
bool isSame(const tick::TickReport& a, const tick::TickReport& b) {
  if (a.force.f_T_W() != b.force.f_T_W() || a.f_T_W != b.f_T_W || a.p_WT != b.p_WT) return false;
  if (a.fault.kind != b.fault.kind || a.held.size() != b.held.size()) return false;
  for (std::size_t i = 0; i < a.held.size(); ++i) {
    if (a.held[i].p_WP != b.held[i].p_WP || a.held[i].status != b.held[i].status) return false;
  }
  return true;
}

}  // namespace

bool isFinite(const tick::TickState& state) {
  bool all = areFinite({state.p_WT, state.asked_T_W, state.bump_T_W, state.gate.v_WT, state.gate.f_T_W});
  for (const double heat : state.gate.heat) all = all && std::isfinite(heat);
  for (const double angle_rad : state.q_rad) all = all && std::isfinite(angle_rad);
  all = all && std::isfinite(state.gate.level) && std::isfinite(state.gate.still_s);
  for (const tick::EntryState& entry : state.entries) all = all && isAllFinite(entry);
  return all;
}

Outcome checkMalformedTick(const tick::TickProgram& program, Input& input) {
  const double phase = input.number("phase", [](Dice& dice) { return dice.between(0.0, 6.0); });
  Run run{program, makeState(program)};
  double worst = 0.0;
  tick::TickInput at;
  at.engage = true;
  at.restart = true;
  std::int64_t tick = 0;
  const auto go = [&](Run& of) {
    of.feed(at);
    worst = std::max(worst, forceError(of));
  };
  const auto advance = [&] {
    ++tick;
    at = tick::TickInput{};
    at.engage = true;
    at.sample.time_ns = tick * kPeriod_ns;
    at.sample.q_rad = anglesAt(tick, phase);
  };
  for (; tick < kBefore;) {
    go(run);
    advance();
  }
  bool stays_finite = true;
  const std::size_t strange = 1 + input.choice("strange", 3);
  for (std::size_t i = 0; i < strange; ++i) {
    spoil(input, at);
    go(run);
    // A lasting fault sends nothing until the Start, which resets what such a tick has left in the laws.
    stays_finite = stays_finite && (run.state.gate.fault.kind != FaultKind::None || isFinite(run.state));
    advance();
  }
  // The Start, compared with a program that never had that input, except for the heat of its motors.
  Run fresh{program, makeState(program)};
  fresh.state.gate.heat = run.state.gate.heat;
  at.restart = true;
  bool same = true;
  for (int i = 0; i < kAfter; ++i) {
    go(run);
    go(fresh);
    same = same && isSame(*run.report, *fresh.report) && isFinite(run.state);
    advance();
  }
  return {same && stays_finite ? worst : kInfinity, false};
}

}  // namespace underact::error_bounds
