#include <benchmark/benchmark.h>

#include "core/arm/inverse.h"
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

void measure(benchmark::State& state, const tick::TickProgram& program) {
  const arm::Geometry& geometry = program.geometry;
  std::vector<arm::JointAngles> joints;
  constexpr int kPath = 1024;
  for (int i = 0; i < kPath; ++i) {
    const double a = 2 * kPi * i / kPath;
    joints.push_back(arm::reach(geometry, Vec3(0.05 * std::cos(a), 0.04 * std::sin(a), 0.03 * std::cos(2 * a))).q_rad);
  }
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

const bool kRegistered = [] {
  for (const bench::NamedShape& shape : bench::shapes()) {
    for (const NamedLaw& law : laws()) {
      benchmark::RegisterBenchmark(("tick/" + shape.name + "/" + law.name).c_str(), measure,
                                   programOf(shape.shape, law.law, Vec3::Ones(), 1));
    }
    benchmark::RegisterBenchmark(("tick_weighted/" + shape.name + "/P").c_str(), measure,
                                 programOf(shape.shape, laws()[0].law, Vec3(1.0, 0.5, 0.7), 1));
  }
  benchmark::RegisterBenchmark("tick/64_spheres/P", measure,
                               programOf(bench::shapes()[1].shape, laws()[0].law, Vec3::Ones(), 64));
  return true;
}();

}  // namespace
}  // namespace underact
