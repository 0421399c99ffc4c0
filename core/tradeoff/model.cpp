#include "core/tradeoff/model.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/scene/compile.h"
#include "core/scene/fields.h"
#include "core/tick/step.h"

namespace underact::tradeoff {
namespace {

constexpr int kRounds = 7;
constexpr int kRate_hz = 1000;

/// A quantity: how to change the scene or its program so that it is computed. false: not possible.
struct Need {
  const char* key;
  const char* what;
  bool (*require)(scene::Description& scene);
  void (*switchOn)(tick::Needs& needs);
  bool (*is_required)(const tick::TickProgram& program);
};

template <class Change>
bool anyControl(scene::Description& scene, const Change& change) {
  for (std::size_t index = 0; index < scene.constraints.size(); ++index) {
    scene::Control control = controlOf(scene, index);
    change(control);
    scene.constraints[index].control = control;
  }
  return true;
}

bool giveLaw(scene::Description& scene, scene::LawType law) {
  return anyControl(scene, [law](scene::Control& control) {
    control.law = std::max(control.law, law);
    control.gains.kd_N_s_per_mm.setConstant(1e-6);
    if (control.law == scene::LawType::PID) control.gains.ki_N_per_mm_s.setConstant(1e-6);
  });
}

bool giveFriction(scene::Description& scene) {
  bool any = false;
  for (scene::Constraint& one : scene.constraints) {
    if (!takesFriction(one.shape)) continue;
    one.friction = scene::Friction{0.2, 0.2};
    any = true;
  }
  return any;
}

bool giveInfluence(scene::Description& scene) {
  bool any = false;
  for (scene::Constraint& one : scene.constraints) {
    if (!takesInfluence(one.shape) || one.side != target::Side::Both) continue;
    one.influence = scene::Influence{};
    any = true;
  }
  return any;
}

bool nothing(scene::Description&) {
  return true;
}

const std::array<Need, 7> kNeeds{{
    {"orientation", "the orientation of the stylus", nothing, [](tick::Needs& needs) { needs.orientation = true; },
     [](const tick::TickProgram& program) { return program.needs.orientation; }},
    {"motor_torques", "the load of the motors: the Jacobian, their heat, the joint limits", nothing,
     [](tick::Needs& needs) { needs.motors = true; },
     [](const tick::TickProgram& program) { return program.needs.motors; }},
    {"error_rate", "the rate of the error (PD)",
     [](scene::Description& scene) { return giveLaw(scene, scene::LawType::PD); }, nullptr,
     [](const tick::TickProgram& program) { return program.needs.rate; }},
    {"error_integral", "the rate and the integral of the error (PID)",
     [](scene::Description& scene) { return giveLaw(scene, scene::LawType::PID); }, nullptr,
     [](const tick::TickProgram& program) { return program.needs.integral; }},
    {"energy", "the energy of each constraint, and the damper of the passivity controller",
     [](scene::Description& scene) {
       return anyControl(scene, [](scene::Control& control) { control.passivity = control::Passivity::Control; });
     },
     nullptr, [](const tick::TickProgram& program) { return program.needs.energy; }},
    {"friction", "the point at which friction holds the target", giveFriction, nullptr,
     [](const tick::TickProgram& program) { return program.needs.friction; }},
    {"influence", "the target between the position and the orientation of the stylus", giveInfluence, nullptr,
     [](const tick::TickProgram& program) {
       return std::any_of(program.entries.begin(), program.entries.end(), [](const tick::Entry& entry) {
         return std::holds_alternative<target::InfluencedShape>(entry.constraint.goal);
       });
     }},
}};

/// The scene with tip position, targets and P laws alone, in its space and metric.
scene::Description bareOf(scene::Description scene) {
  anyControl(scene, [](scene::Control& control) {
    control.law = scene::LawType::P;
    control.gains.kd_N_s_per_mm.setZero();
    control.gains.ki_N_per_mm_s.setZero();
    control.passivity = control::Passivity::Off;
  });
  for (scene::Constraint& one : scene.constraints) {
    one.influence.reset();
    one.friction.reset();
  }
  return scene;
}

Result<tick::TickProgram> bareProgram(const scene::Description& scene) {
  Result<tick::TickProgram> program = scene::compile(scene);
  if (!program) return program;
  program.value().needs.motors = false;
  return program;
}

/// The bare scene with the rows that `wanted` selects; none: one of them is not possible.
template <class Wanted>
std::optional<tick::TickProgram> programWith(const scene::Description& bare, const Wanted& wanted) {
  scene::Description scene = bare;
  bool can = false;
  for (const Need& row : kNeeds) can = (wanted(row) && row.require(scene)) || can;
  const Result<tick::TickProgram> compiled = bareProgram(scene);
  if (!can || !compiled) return std::nullopt;
  tick::TickProgram program = compiled.value();
  for (const Need& row : kNeeds) {
    if (wanted(row) && row.switchOn != nullptr) row.switchOn(program.needs);
  }
  return program;
}

double medianTick_ns(const tick::TickProgram& program, const JointPath& path) {
  tick::TickState state = makeState(program);
  tick::TickReport report;
  tick::TickInput input;
  input.engage = input.restart = true;
  lab::Stopwatch watch(path.size());
  for (const arm::Sample& sample : path) {
    input.sample = sample;
    watch.time([&] { step(program, input, state, report); });
    input.restart = false;
  }
  return watch.cost().p50_ns;
}

/// The median over rounds of each program's median.
std::vector<double> inTurn_ns(const std::vector<const tick::TickProgram*>& programs, const JointPath& path) {
  std::vector<std::vector<double>> all(programs.size());
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t index = 0; index < programs.size(); ++index)
      all[index].push_back(medianTick_ns(*programs[index], path));
  }
  std::vector<double> medians;
  for (const std::vector<double>& times : all) medians.push_back(lab::quantile(times, 0.5));
  return medians;
}

}  // namespace

Result<Model> modelOf(const Bench& bench) {
  const Result<tick::TickProgram> own = scene::compile(bench.scene);
  if (!own) return own.problems();
  const scene::Description bare_scene = bareOf(bench.scene);
  const Result<tick::TickProgram> bare = bareProgram(bare_scene);
  if (!bare) return bare.problems();
  const auto everything = programWith(bare_scene, [](const Need&) { return true; });
  std::array<std::optional<tick::TickProgram>, kNeeds.size()> each;
  std::vector<const tick::TickProgram*> programs{&bare.value(), &own.value(), everything ? &*everything : &own.value()};
  for (std::size_t row = 0; row < kNeeds.size(); ++row) {
    each[row] = programWith(bare_scene, [row](const Need& one) { return &one == &kNeeds[row]; });
    if (each[row]) programs.push_back(&*each[row]);
  }
  const std::vector<double> times_ns = inTurn_ns(programs, jointPathOf(bench, timesOf(bench, kRate_hz), false));
  Model model{times_ns[0], times_ns[1], times_ns[2], {}};
  std::size_t next = 3;
  for (std::size_t row = 0; row < kNeeds.size(); ++row) {
    Quantity quantity{kNeeds[row].key, kNeeds[row].what, kNeeds[row].is_required(own.value()), std::nullopt};
    if (each[row]) quantity.adds_ns = times_ns[next++] - model.bare_ns;
    model.quantities.push_back(quantity);
  }
  return model;
}

}  // namespace underact::tradeoff
