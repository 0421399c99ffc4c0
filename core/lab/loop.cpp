#include "core/lab/loop.h"

#include <algorithm>
#include <utility>

#include "core/base/translate.h"
#include "core/base/units.h"

namespace underact::lab {
namespace {

constexpr double kNotReached_m = 1e-6;

}  // namespace

SimulatedLoop::SimulatedLoop(const sim::Plant& plant, const Vec3& p_WT, int rate_hz)
    : plant_(plant), arm_(sim::restingState(plant, p_WT)), period_ns_(1'000'000'000 / rate_hz) {
  setpoint_.p_WT = arm_.p_WT;
  input_.engage = true;
  input_.restart = true;
}

const tick::TickReport& SimulatedLoop::tick(const tick::TickProgram& program, tick::TickState& state) {
  move();
  return think(program, state);
}

void SimulatedLoop::move() {
  arm_ = advance(plant_, arm_, report_.force.f_T_W(), setpoint_, period_ns_, report_.force.m_T_W());
  input_.sample.time_ns += period_ns_;
  input_.sample.q_rad = shownAngles(plant_, arm_);
}

const tick::TickReport& SimulatedLoop::think(const tick::TickProgram& program, tick::TickState& state) {
  step(program, input_, state, report_);
  input_.restart = false;
  return report_;
}

double SimulatedLoop::period_s() const {
  return kSecondPerNanosecond * static_cast<double>(period_ns_);
}

safety::Limits withoutLimits(safety::Limits limits) {
  limits.max_force_N = 1e6;
  limits.max_slew_N_per_s = limits.calm_speed_m_per_s = limits.max_speed_m_per_s = limits.max_jump_m_per_s = kInfinity;
  limits.edge_rad = 0.0;
  limits.thermal = {};
  return limits;
}

tick::TickReport firstTick(const tick::TickProgram& program, const sim::Plant& plant, const Vec3& p_WT) {
  tick::TickState state = makeState(program);
  tick::TickReport report;
  tick::TickInput input;
  input.engage = input.restart = true;
  input.sample.q_rad = sim::restingState(plant, p_WT).q_rad;
  step(program, input, state, report);
  return report;
}

bool isWithinReach(const sim::Plant& plant, const Vec3& p_WT) {
  return (sim::restingState(plant, p_WT).p_WT - p_WT).norm() <= kNotReached_m;
}

Result<Vec3> restingPlace(const tick::TickProgram& program, const sim::Plant& plant, Vec3 p_WT) {
  for (int round = 0; round < 50; ++round) {
    const tick::TickReport report = firstTick(program, plant, p_WT);
    if (report.held.size() != 1 || report.held[0].status != target::Status::Unique)
      return Problems{
          {phrase(TRANSLATE_NOOP("problem", "From there no single target is nearest. Start from another position."))}};
    const Vec3 p_WP = report.held[0].p_WP;
    const double off_m = (p_WP - report.p_WT).norm();
    p_WT = p_WP;
    if (off_m < 1e-9) return p_WT;
    if (!isWithinReach(plant, p_WT))
      return Problems{
          {phrase(TRANSLATE_NOOP("problem", "The arm does not reach the target there. Start from another position."))}};
  }
  return Problems{{phrase(
      TRANSLATE_NOOP("problem", "The target moves while the tip approaches it. Start from another position."))}};
}

Result<scene::Description> onlyOne(scene::Description scene, const std::string& name) {
  const auto chosen = [&](const scene::Constraint& one) { return name.empty() || one.name == name; };
  const auto found = std::find_if(scene.constraints.begin(), scene.constraints.end(), chosen);
  if (found == scene.constraints.end())
    return Problems{
        {phrase(TRANSLATE_NOOP("problem", "The scene has no constraint \"%1\"; choose one of its names."), {name}),
         {scene.file}}};
  if (name.empty() && scene.constraints.size() > 1)
    return Problems{
        {phrase(TRANSLATE_NOOP("problem", "The scene has %1 constraints; name the one to measure, such as \"%2\"."),
                {std::to_string(scene.constraints.size()), found->name}),
         {scene.file}}};
  if (found->side != target::Side::Both && !std::holds_alternative<scene::VirtualManipulator>(found->shape))
    return Problems{
        {phrase(TRANSLATE_NOOP("problem",
                               "\"%1\" is a wall: it pushes but never pulls, so it does not hold the tip at "
                               "a target. Measure one whose side is \"both\"."),
                {found->name}),
         found->place}};
  const auto index = static_cast<std::size_t>(found - scene.constraints.begin());
  scene::Constraint one = scene.constraints[index];
  one.control = controlOf(scene, index);
  scene.constraints = {std::move(one)};
  return scene;
}

}  // namespace underact::lab
