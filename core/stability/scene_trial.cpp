#include "core/stability/scene_trial.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/lab/loop.h"
#include "core/scene/compile.h"
#include "core/scene/scene_arm.h"
#include "core/stability/exact.h"

namespace underact::stability {
namespace {

constexpr double kSpeed_m_per_s = 5e-3;  // 0.05 mm of motion at 500 N/m: robots are still linear
constexpr double kRamps_s = 0.5;         // the gate's take 0.3 s
constexpr double kSettling = 30.0;       // periods over 2 pi, critically damped: 1e-12 is left
constexpr int kLooks = 16;               // times as long at most, while hardly anything changes
constexpr double kTells = 5e-3;          // there is no noise in it
constexpr double kHolds = 0.05;          // relative to the motion: the least distance of a held tip from its target
constexpr double kActive_J = 1e-12;      // rounding of the observer's sum, of some 1e-7 J exchanged

scene::Description withStiffness(scene::Description scene, const SceneWall& wall, double stiffness_N_per_m) {
  scene::Control& control = *scene.constraints[0].control;  // onlyOne() gave it one
  control.law = wall.kd_N_s_per_m > 0.0 ? scene::LawType::PD : scene::LawType::P;
  control.gains = {Vec3::Constant(stiffness_N_per_m / kNewtonPerMetre),
                   Vec3::Constant(wall.kd_N_s_per_m / kNewtonPerMetre), Vec3::Zero()};
  control.passivity = control::Passivity::Observe;
  return scene;
}

sim::Plant plantOf(const SceneWall& wall, const scene::Description& scene) {
  sim::ArmModel model;
  model.mass_kg = wall.mass_kg;
  model.damping_N_s_per_m = wall.damping_N_s_per_m;
  model.friction_N = wall.friction_N;
  model.encoders = wall.encoders;
  return sim::makePlant(scene::armOf(scene), model, {0.0, 0.0, 0.0}, integrationOf(scene.simulation));
}

int ticksIn(double seconds, const SceneWall& wall) {
  return static_cast<int>(seconds * wall.rate_hz);
}

/// The rest position of the tip, starting from from_W with enough damping. The target of a robot with orientation
/// depends on the stylus, too, so that it cannot be found by iteration, and the rest position depends on the stiffness:
/// from 10 to 5000 N/m by some mm.
Result<Vec3> restingPlace(const SceneWall& wall, const tick::TickProgram& program, sim::Plant plant,
                          double stiffness_N_per_m) {
  const double swing_s = std::sqrt(wall.mass_kg / stiffness_N_per_m);
  plant.model.damping_N_s_per_m += 2.0 * wall.mass_kg / swing_s;  // critical
  plant.model.friction_N = 0.0;
  lab::SimulatedLoop loop(plant, wall.from_W, wall.rate_hz);
  tick::TickState state = makeState(program);
  for (int tick = ticksIn(kRamps_s + kSettling * swing_s, wall); tick-- > 0;) {
    const tick::TickReport& report = loop.tick(program, state);
    if (tick == 0 && (report.held.size() != 1 || report.held[0].status != target::Status::Unique))
      return Problems{
          {phrase(TRANSLATE_NOOP("problem", "From there no single target is nearest. Start from another position."))}};
  }
  return loop.arm().p_WT;
}

/// The tip at rest, with the gate's ramps completed.
struct AtRest {
  lab::SimulatedLoop loop;
  tick::TickState state;
  double error_m = 0.0;
};

AtRest atRest(const SceneWall& wall, const tick::TickProgram& program, const sim::Plant& plant, const Vec3& p_WRest) {
  AtRest rest{lab::SimulatedLoop(plant, p_WRest, wall.rate_hz), makeState(program)};
  for (int tick = ticksIn(kRamps_s, wall); tick-- > 0;) rest.error_m = errorOf(rest.loop.tick(program, rest.state));
  return rest;
}

SceneTrialResult follow(const SceneWall& wall, const tick::TickProgram& program, AtRest rest, const Vec3& direction_W,
                        double stiffness_N_per_m) {
  auto& [loop, state, rest_m] = rest;
  loop.nudge(kSpeed_m_per_s * direction_W.normalized());
  const double swing_m = kSpeed_m_per_s * std::sqrt(wall.mass_kg / stiffness_N_per_m);
  const int min = ticksToObserve(wall.mass_kg, stiffness_N_per_m, loop.period_s());
  const bool is_smooth = wall.friction_N == 0.0 && !wall.encoders;
  SwingObserver observer(swing_m, {min, kLooks * min, is_smooth ? Motion::Smooth : Motion::Stepped, kTells});
  SceneTrialResult result;
  double farthest_m = 0.0;
  for (bool goes_on = true; goes_on;) {
    const tick::TickReport& report = loop.tick(program, state);
    const bool is_lost = report.fault.kind != FaultKind::None || report.held.size() != 1;
    const double off_m = is_lost ? kNotANumber : errorOf(report) - rest_m;
    result.min_energy_J = std::min(result.min_energy_J, is_lost ? 0.0 : report.held[0].energy_J);
    farthest_m = is_lost ? kInfinity : std::max(farthest_m, std::abs(off_m));
    goes_on = observer.goesOn(off_m);
  }
  result.trial = observer.trial();
  result.holds = !(farthest_m < kHolds * swing_m);
  result.is_passive = result.min_energy_J >= -kActive_J;
  return result;
}

// A direction oblique to all axes, and the opposite one, since a rim holds in one direction only; and another one,
// which may excite what the first does not.
const Vec3 kDirections_W[]{{0.9, -0.5, 0.6}, {-0.9, 0.5, -0.6}, {1.0, 0.8, -0.6}};

/// one: the scene with the constraint in question alone.
Result<SceneTrialResult> tryOne(const SceneWall& wall, const scene::Description& one, double stiffness_N_per_m) {
  Result<tick::TickProgram> program = scene::compile(withStiffness(one, wall, stiffness_N_per_m));
  if (!program) return program.problems();
  program.value().limits = lab::withoutLimits(program.value().limits);
  const sim::Plant plant = plantOf(wall, one);
  const Result<Vec3> p_WRest = restingPlace(wall, program.value(), plant, stiffness_N_per_m);
  if (!p_WRest) return p_WRest.problems();
  const AtRest rest = atRest(wall, program.value(), plant, p_WRest.value());
  SceneTrialResult worst;
  for (const Vec3& direction_W : kDirections_W) {
    const SceneTrialResult trial = follow(wall, program.value(), rest, direction_W, stiffness_N_per_m);
    if (&direction_W != &kDirections_W[2]) worst.holds = worst.holds && trial.holds;
    worst.min_energy_J = std::min(worst.min_energy_J, trial.min_energy_J);
    worst.is_passive = worst.is_passive && trial.is_passive;
    const bool worse = std::pair(trial.trial.behaviour, trial.trial.amplitude_m) >=
                       std::pair(worst.trial.behaviour, worst.trial.amplitude_m);
    if (worse) worst.trial = trial.trial;
    if (trial.trial.behaviour == Behaviour::Grows) break;
  }
  return worst;
}

}  // namespace

Result<SceneTrialResult> tryScene(const SceneWall& wall, double stiffness_N_per_m) {
  const Result<scene::Description> one = lab::onlyOne(wall.scene, wall.constraint);
  if (!one) return one.problems();
  if (!arm::solvesInTick(scene::armOf(wall.scene).geometry))
    return Problems{
        {phrase(TRANSLATE_NOOP("problem",
                               "The trial pushes a mass at the tip, as haptic arms have one; the arm \"%1\" "
                               "has links instead."),
                {wall.scene.arm})}};
  return tryOne(wall, one.value(), stiffness_N_per_m);
}

Result<double> simulatedLimit(const SceneWall& wall, double share) {
  constexpr double kMin_N_per_m = 10.0, kMax_N_per_m = 1e6;
  const Result<scene::Description> one = lab::onlyOne(wall.scene, wall.constraint);
  if (!one) return one.problems();
  const Result<SceneTrialResult> soft = tryOne(wall, one.value(), kMin_N_per_m);
  if (!soft) return soft.problems();
  if (!soft.value().holds)
    return Problems{{phrase(TRANSLATE_NOOP(
        "problem", "Nothing holds the tip there: the target follows the tip everywhere, so no stiffness is felt."))}};
  if (soft.value().trial.behaviour == Behaviour::Grows) return 0.0;
  Problems problems;
  const auto is_calm = [&](double K) {
    if (!problems.empty()) return false;  // further results would be meaningless
    const Result<SceneTrialResult> trial = tryOne(wall, one.value(), K);
    if (!trial) problems = trial.problems();
    return trial && trial.value().trial.behaviour != Behaviour::Grows;
  };
  const double limit = limitBySearch(is_calm, kMin_N_per_m, kMax_N_per_m, share);
  if (!problems.empty()) return problems;
  return limit;
}

}  // namespace underact::stability
