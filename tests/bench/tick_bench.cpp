#include <benchmark/benchmark.h>

#include "core/arm/forward.h"
#include "core/arm/inverse.h"
#include "core/arm/jacobian.h"
#include "core/base/units.h"
#include "core/tick/step.h"
#include "tests/bench/cases.h"

// ns for a whole tick: kinematics, target, law, gate and report, for each shape and law, over joints along a closed
// path of the tip as a hand would move it (0.3 m/s).
namespace underact {
namespace {

struct NamedLaw {
  std::string name;
  control::Law law;
};

std::vector<NamedLaw> laws() {
  const Vec3 kp(500, 500, 500), kd(1, 1, 1), ki(50, 50, 50);
  return {{"P", control::P{kp}}, {"PD", control::PD{kp, kd}}, {"PID", control::PID{kp, kd, ki, 0.88}}};
}

constexpr std::size_t kPath = 1024;

std::vector<arm::JointAngles> jointPath(const arm::Geometry& geometry) {
  std::vector<arm::JointAngles> joints;
  for (std::size_t i = 0; i < kPath; ++i) {
    const double a = 2 * kPi * static_cast<double>(i) / static_cast<double>(kPath);
    joints.push_back(
        arm::solvePosition(geometry, Vec3(0.05 * std::cos(a), 0.04 * std::sin(a), 0.03 * std::cos(2 * a))).q_rad);
  }
  return joints;
}

void measureTick(benchmark::State& state, const tick::TickProgram& program) {
  const std::vector<arm::JointAngles> joints = jointPath(program.geometry);
  tick::TickState memory = tick::makeState(program);
  tick::TickReport report;
  tick::TickInput input;
  input.engage = true;
  input.period_s = 1e-3;  // as the servo says it
  std::size_t at = 0;
  for (auto _ : state) {
    input.sample.time_ns += 1'000'000;
    input.sample.q_rad = joints[at];
    at = (at + 1) % kPath;
    tick::step(program, input, memory, report);
    benchmark::DoNotOptimize(report);
  }
}

tick::TickProgram programOf(const shape::Shape& shape, const control::Law& law, const Vec3& stiffness,
                            std::size_t count) {
  const arm::Preset& arm = *arm::findPreset(arm::kDefaultArm);
  const tick::Entry entry{target::makeConstraint(shape, target::Side::Both, stiffness), law};
  return tick::makeProgram(arm.geometry, std::vector<tick::Entry>(count, entry), tick::Combine::Sum,
                           safety::limitsForHands(arm.continuous_force_N, Vec3(0.155, 0.112, 0.131)), arm.limits);
}

/// What the kinematics alone takes.
void measureKinematics(benchmark::State& state, bool whole) {
  const arm::Geometry& geometry = arm::findPreset(arm::kDefaultArm)->geometry;
  const std::vector<arm::JointAngles> joints = jointPath(geometry);
  std::size_t at = 0;
  for (auto _ : state) {
    if (whole) {
      benchmark::DoNotOptimize(arm::tipPose(geometry, joints[at]));
      benchmark::DoNotOptimize(arm::positionJacobian(geometry, joints[at]));
    } else {
      benchmark::DoNotOptimize(arm::tipPosition(geometry, joints[at]));
    }
    at = (at + 1) % kPath;
  }
}

/// A sphere with P: nothing but the clamp, then with one of the rest, then with all that a scene has.
void registerParts() {
  benchmark::RegisterBenchmark("tick_parts/place_alone", measureKinematics, false);
  benchmark::RegisterBenchmark("tick_parts/pose_and_jacobian", measureKinematics, true);
  const arm::Preset& arm = *arm::findPreset(arm::kDefaultArm);
  const safety::Limits all = safety::limitsForHands(arm.continuous_force_N, Vec3(0.155, 0.112, 0.131));
  safety::Limits bare;
  bare.max_force_N = all.max_force_N;
  safety::Limits slew = bare, speed = bare, edge = bare, heat = bare;
  slew.max_slew_N_per_s = all.max_slew_N_per_s;
  speed.calm_speed_m_per_s = all.calm_speed_m_per_s;
  speed.max_speed_m_per_s = all.max_speed_m_per_s;
  speed.max_jump_m_per_s = all.max_jump_m_per_s;
  edge.edge_rad = all.edge_rad;
  heat.thermal = all.thermal;
  tick::Entry entry{target::makeConstraint(bench::shapes()[1].shape, target::Side::Both, Vec3::Ones()), laws()[0].law};
  const auto add = [&](const char* name, const safety::Limits& limits) {
    benchmark::RegisterBenchmark((std::string("tick_parts/") + name).c_str(), measureTick,
                                 tick::makeProgram(arm.geometry, {entry}, tick::Combine::Sum, limits, arm.limits));
  };
  add("bare", bare);
  add("slew", slew);
  add("speed", speed);
  add("stops", edge);
  add("heat", heat);
  add("all_limits", all);
  entry.passivity = control::Passivity::Observe;
  add("observer", bare);
  add("all_limits_and_observer", all);
}

const bool kTicksRegistered = [] {
  registerParts();
  for (const bench::NamedShape& shape : bench::shapes()) {
    for (const NamedLaw& law : laws()) {
      benchmark::RegisterBenchmark(("tick/" + shape.name + "/" + law.name).c_str(), measureTick,
                                   programOf(shape.shape, law.law, Vec3::Ones(), 1));
    }
    benchmark::RegisterBenchmark(("tick_weighted/" + shape.name + "/P").c_str(), measureTick,
                                 programOf(shape.shape, laws()[0].law, Vec3(1.0, 0.5, 0.7), 1));
  }
  benchmark::RegisterBenchmark("tick/64_spheres/P", measureTick,
                               programOf(bench::shapes()[1].shape, laws()[0].law, Vec3::Ones(), 64));
  return true;
}();

}  // namespace
}  // namespace underact
