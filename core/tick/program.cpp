#include "core/tick/program.h"

#include <utility>

namespace underact::tick {

TickProgram makeProgram(const arm::Geometry& geometry, std::vector<Entry> entries, Combine combine,
                        const safety::Limits& limits, const arm::JointLimits& joint_limits) {
  TickProgram program{Needs{}, geometry, joint_limits, std::move(entries), combine, limits};
  for (const Entry& entry : program.entries) {
    program.needs.rate |= control::needsRate(entry.law);
    program.needs.integral |= control::needsIntegral(entry.law);
    program.needs.orientation |= entry.constraint.influenced;
    program.needs.metric |= entry.constraint.weighted;
    program.needs.joints |= entry.space == Space::Joint;
  }
  program.needs.choice = combine == Combine::Nearest && program.entries.size() > 1;
  return program;
}

TickState makeState(const TickProgram& program) {
  TickState state;
  if (program.needs.rate) state.laws.resize(program.entries.size());
  if (program.needs.orientation) state.influences.resize(program.entries.size());
  if (program.needs.joints) state.followers.resize(program.entries.size());
  return state;
}

std::size_t bytesOf(const TickState& state) {
  return sizeof(TickState) + state.laws.size() * sizeof(control::LawState) +
         state.influences.size() * sizeof(target::InfluenceState) + state.followers.size() * sizeof(arm::FollowerState);
}

void carryOver(const TickState& last, TickState& next, Carry what) noexcept {
  next.time_ns = last.time_ns;
  next.has_time = last.has_time;
  next.p_WT = last.p_WT;
  next.limited = last.limited;
  next.gate = last.gate;
  if (what == Carry::Arm) return;
  if (last.laws.size() == next.laws.size()) {
    for (std::size_t index = 0; index < next.laws.size(); ++index) next.laws[index] = last.laws[index];
  }
  if (what == Carry::ArmAndMovedLaws) {
    for (control::LawState& law : next.laws) law.has_last = false;
  }
  if (last.influences.size() == next.influences.size()) {
    for (std::size_t index = 0; index < next.influences.size(); ++index)
      next.influences[index] = last.influences[index];
  }
  if (last.followers.size() == next.followers.size()) {
    for (std::size_t index = 0; index < next.followers.size(); ++index) next.followers[index] = last.followers[index];
  }
}

}  // namespace underact::tick
