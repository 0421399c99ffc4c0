#include "core/tick/program.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/sound.h"

namespace underact::tick {
namespace {

/// Entry by entry, where both have as many.
template <class State>
void carryAll(const std::vector<State>& last, std::vector<State>& next) noexcept UNDERACT_REAL_TIME {
  if (last.size() != next.size()) return;
  for (std::size_t index = 0; index < next.size(); ++index) next[index] = last[index];
}

}  // namespace

TickProgram makeProgram(const arm::Geometry& geometry, std::vector<Entry> entries, Combine combine,
                        const safety::Limits& limits, const arm::JointLimits& joint_limits) {
  TickProgram program{Needs{}, geometry, joint_limits, std::move(entries), combine, limits};
  for (const Entry& entry : program.entries) {
    program.needs.rate |= control::needsRate(entry.law);
    program.needs.integral |= control::needsIntegral(entry.law);
    const std::optional<manipulator::Manipulator>& robot = entry.constraint.manipulator;
    const bool turns = robot && robot->orientation != manipulator::Orientation::None;
    program.needs.orientation |= entry.constraint.influenced || turns;
    program.needs.robots |= robot.has_value();
    program.needs.meshes |= entry.constraint.mesh.has_value();
    program.needs.curves |= entry.constraint.curve.has_value();
    program.needs.friction |= entry.constraint.friction.isThere();
    program.needs.metric |= entry.constraint.weighted;
    program.needs.energy |= entry.passivity != control::Passivity::Off;
    program.needs.joints |= entry.space == Space::Joint;
  }
  program.needs.motors = limits.edge_rad > 0.0 || (limits.thermal.continuous_N_m.array() > 0.0).any();
  program.needs.choice = combine == Combine::Nearest && program.entries.size() > 1;
  return program;
}

TickState makeState(const TickProgram& program) {
  TickState state;
  if (program.needs.rate) state.laws.resize(program.entries.size());
  if (program.needs.orientation) state.influences.resize(program.entries.size());
  if (program.needs.robots) state.robots.resize(program.entries.size());
  if (program.needs.meshes) state.meshes.resize(program.entries.size());
  if (program.needs.curves) state.curves.resize(program.entries.size());
  if (program.needs.friction) state.grips.resize(program.entries.size());
  if (program.needs.energy) state.energies.resize(program.entries.size());
  if (program.needs.joints) state.followers.resize(program.entries.size());
  return state;
}

bool isSound(const TickState& state, const TickProgram& program) {
  const auto all = [](const auto& parts) {
    return std::all_of(parts.begin(), parts.end(), [](const auto& part) { return isSound(part); });
  };
  for (std::size_t index = 0; index < program.entries.size(); ++index) {
    const target::Constraint& constraint = program.entries[index].constraint;
    const mesh::Surface* const surface = constraint.mesh ? constraint.mesh->surface.get() : nullptr;
    const curve::Curve* const curve = constraint.curve ? constraint.curve->curve.get() : nullptr;
    if (index < state.meshes.size() && !isSound(state.meshes[index], surface)) return false;
    if (index < state.curves.size() && !isSound(state.curves[index], curve)) return false;
  }
  const auto isNumber = [](double angle_rad) { return std::isfinite(angle_rad); };
  return isFlag(state.has_time) && isFlag(state.limited) && isFlag(state.retuned) && state.p_WT.allFinite() &&
         std::all_of(state.q_rad.begin(), state.q_rad.end(), isNumber) && isSound(state.gate) && all(state.laws) &&
         all(state.influences) && all(state.robots) && all(state.grips) && all(state.energies) && all(state.followers);
}

std::size_t bytesOf(const TickState& state) {
  return sizeof(TickState) + state.laws.size() * sizeof(control::LawState) +
         state.influences.size() * sizeof(target::InfluenceState) + state.robots.size() * sizeof(manipulator::State) +
         state.meshes.size() * sizeof(target::MeshState) + state.curves.size() * sizeof(target::CurveState) +
         state.grips.size() * sizeof(target::Grip) + state.energies.size() * sizeof(control::EnergyState) +
         state.followers.size() * sizeof(arm::FollowerState);
}

void carryOver(const TickState& last, TickState& next, Carry what) noexcept {
  next.time_ns = last.time_ns;
  next.has_time = last.has_time;
  next.p_WT = last.p_WT;
  next.limited = last.limited;
  next.q_rad = last.q_rad;
  next.gate = last.gate;
  if (what == Carry::Arm) return;
  next.asked_T_W = last.asked_T_W;
  next.bump_T_W = last.bump_T_W;
  next.retuned = true;
  carryAll(last.laws, next.laws);
  carryAll(last.energies, next.energies);
  carryAll(last.influences, next.influences);
  carryAll(last.robots, next.robots);
  carryAll(last.followers, next.followers);
  carryAll(last.meshes, next.meshes);
  carryAll(last.grips, next.grips);
  carryAll(last.curves, next.curves);
  if (what != Carry::ArmAndMovedLaws) return;
  // The way that a target went is none of the hand's: neither a rate, nor a way through a wall that was elsewhere. And
  // where a target held on, its surface may be no longer.
  for (control::LawState& law : next.laws) law.velocity.has_last = false;
  for (target::MeshState& mesh : next.meshes) mesh.touch.knows_last = false;
  for (target::Grip& grip : next.grips) grip.holds = false;
}

}  // namespace underact::tick
