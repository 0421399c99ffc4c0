#include "core/tradeoff/run.h"

#include <algorithm>
#include <cmath>

#include "core/arm/inverse.h"
#include "core/arm/preset.h"
#include "core/base/units.h"
#include "core/lab/loop.h"
#include "core/scene/compile.h"
#include "core/scene/scene_arm.h"
#include "core/sim/arm_model.h"

namespace underact::tradeoff {
namespace {

sim::Plant plantOf(const Bench& bench, const scene::Description& scene, bool exact) {
  sim::ArmModel model = *sim::findArmModel(sim::kDefaultArmModel);
  model.encoders = !exact;
  return sim::makePlant(scene::armOf(scene), model, bench.hand.hand, integrationOf(scene.simulation));
}

std::int64_t nanosecondsAt(double time_s) {
  return std::llround(1e9 * time_s);
}

/// The joints at the position to which the hand moves the tip, as far as the arm follows.
arm::JointAngles jointsAt(const sim::Plant& plant, const sim::HandSetpoint& setpoint) {
  sim::PlantState state = restingState(plant, setpoint.p_WT);
  if (setpoint.turns) state.q_rad = arm::withinLimits(plant.arm.limits, arm::solveWrist(state.q_rad, setpoint.R_WT));
  return shownAngles(plant, state);
}

void add(const tick::TickReport& report, const tick::TickState& state, Walk& walk) {
  for (std::size_t index = 0; index < report.held.size(); ++index) {
    const tick::ConstraintReport& held = report.held[index];
    walk.p_WP[index].push_back(held.p_WP);
    walk.e_W[index].push_back(held.p_WP - report.p_WT);
    walk.distance_m[index].push_back(held.distance_m);
    walk.acts[index].push_back(held.status == target::Status::Unique && held.acts);
    if (state.needs.rate) walk.rate_W[index].push_back(state.entries[index].law.velocity.rate_W);
  }
}

bool anyActs(const tick::TickReport& report) {
  return std::any_of(report.held.begin(), report.held.end(), [](const tick::ConstraintReport& held) {
    return held.acts && held.status == target::Status::Unique;
  });
}

}  // namespace

Bench benchOf(const scene::Description& scene, const sim::HandScript& hand, double seconds) {
  return {scene, sim::madeFor(scene::armOf(scene), hand), seconds};
}

std::vector<double> timesOf(const Bench& bench, int rate_hz) {
  std::vector<double> times;
  for (int tick = 0; tick < static_cast<int>(bench.seconds * rate_hz); ++tick)
    times.push_back(static_cast<double>(tick) / rate_hz);
  return times;
}

Result<Run> run(const Bench& bench, const Settings& settings, bool exact) {
  const scene::Description scene = withSettings(bench.scene, settings);
  const Result<tick::TickProgram> program = scene::compile(scene);
  if (!program) return program.problems();
  lab::SimulatedLoop loop(plantOf(bench, scene, exact), setpointAt(bench.hand, 0).p_WT, settings.rate_hz);
  tick::TickState state = makeState(program.value());
  const auto ticks = static_cast<std::size_t>(bench.seconds * settings.rate_hz);
  lab::Stopwatch of_tick(ticks), of_arm(ticks);
  Run result;
  result.rate_hz = settings.rate_hz;
  result.p_WT.reserve(ticks);
  result.f_T_W.reserve(ticks);
  for (std::size_t tick = 0; tick < ticks && !result.faulted; ++tick) {
    loop.setSetpoint(setpointAt(bench.hand, nanosecondsAt(static_cast<double>(tick + 1) / settings.rate_hz)));
    of_arm.time([&] { loop.move(); });
    const tick::TickReport* report = nullptr;
    of_tick.time([&] { report = &loop.think(program.value(), state); });
    result.p_WT.push_back(loop.arm().p_WT);
    result.f_T_W.push_back(report->force.f_T_W());
    result.faulted = report->fault.kind != FaultKind::None;
  }
  result.tick = of_tick.cost();
  result.arm = of_arm.cost();
  return result;
}

JointPath jointPathOf(const Bench& bench, const std::vector<double>& at_s, bool encoders) {
  const sim::Plant plant = plantOf(bench, bench.scene, !encoders);
  JointPath path(at_s.size());
  for (std::size_t tick = 0; tick < at_s.size(); ++tick) {
    path[tick].time_ns = nanosecondsAt(at_s[tick]) + 1;  // a first one at 0 would count as no time
    path[tick].q_rad = jointsAt(plant, setpointAt(bench.hand, nanosecondsAt(at_s[tick])));
  }
  return path;
}

Result<Walk> walk(const Bench& bench, const Settings& settings, const JointPath& path) {
  const scene::Description scene = withSettings(bench.scene, settings);
  const Result<tick::TickProgram> program = scene::compile(scene);
  if (!program) return program.problems();
  tick::TickState state = makeState(program.value());
  tick::TickReport report;
  tick::TickInput input;
  input.engage = input.restart = true;
  const std::size_t constraints = scene.constraints.size();
  Walk result;
  result.p_WP.resize(constraints);
  result.e_W.resize(constraints);
  result.distance_m.resize(constraints);
  result.acts.resize(constraints);
  if (state.needs.rate) result.rate_W.resize(constraints);
  lab::Stopwatch of_tick(path.size());
  for (const arm::Sample& sample : path) {
    input.sample = sample;
    of_tick.time([&] { step(program.value(), input, state, report); });
    input.restart = false;
    if (report.held.size() == constraints) add(report, state, result);
    if (!anyActs(report)) of_tick.forgetLast();
  }
  result.tick = of_tick.cost();
  return result;
}

namespace {

/// The value between two ticks, by interpolation; at a tick exactly its own.
Vec3 between(const std::vector<Vec3>& values, std::size_t tick, double share) {
  if (share == 0.0) return values[tick];
  return values[tick] + share * (values[tick + 1] - values[tick]);
}

}  // namespace

RunDifference differenceOf(const Run& coarse, const Run& fine) {
  RunDifference result;
  if (coarse.p_WT.empty() || fine.p_WT.empty()) return result;
  const auto coarse_hz = static_cast<std::size_t>(coarse.rate_hz), fine_hz = static_cast<std::size_t>(fine.rate_hz);
  double sum_m2 = 0.0, sum_N2 = 0.0;
  std::size_t count = 0;
  for (std::size_t tick = 0; tick < coarse.p_WT.size(); ++tick) {
    // Both begin a period after 0. The finer rate need not be a multiple of the servo's.
    const std::size_t other = (tick + 1) * fine_hz / coarse_hz - 1;
    const double share = static_cast<double>((tick + 1) * fine_hz % coarse_hz) / static_cast<double>(coarse_hz);
    if (other + (share > 0.0 ? 1 : 0) >= fine.p_WT.size()) break;
    const double off_m = (coarse.p_WT[tick] - between(fine.p_WT, other, share)).norm();
    sum_m2 += off_m * off_m;
    sum_N2 += (coarse.f_T_W[tick] - between(fine.f_T_W, other, share)).squaredNorm();
    result.max_m = std::max(result.max_m, off_m);
    ++count;
  }
  result.rms_m = std::sqrt(sum_m2 / static_cast<double>(count));
  result.rms_N = std::sqrt(sum_N2 / static_cast<double>(count));
  return result;
}

}  // namespace underact::tradeoff
