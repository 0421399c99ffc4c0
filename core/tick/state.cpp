#include "core/tick/state.h"

#include <algorithm>
#include <cmath>

#include "core/base/valid_bytes.h"

namespace underact::tick {
namespace {

/// Carries over what both programs need; what one of them left untouched means nothing to the other.
void carryEntry(const Needs& of_last, const EntryState& last, const Needs& of_next,
                EntryState& next) noexcept UNDERACT_REAL_TIME {
  target::carryOver(last.target.memory, next.target.memory);
  if (of_last.friction && of_next.friction) next.target.grip = last.target.grip;
  if (of_last.energy && of_next.energy) next.energy = last.energy;
  if (of_last.joints && of_next.joints) next.follower = last.follower;
  if (of_last.rate && of_next.rate) next.law = last.law;
}

/// Where a target is now.
target::Placing placeNow(const EntryState& entry) noexcept UNDERACT_REAL_TIME {
  const Carried& carried = entry.carried;
  if (carried.total == 0) return entry.end;
  return target::between(carried.from, entry.end,
                         static_cast<double>(carried.done) / static_cast<double>(carried.total));
}

/// Whether it is on its way.
bool carry(const EntryState& last, EntryState& next, std::int64_t over_ticks) noexcept UNDERACT_REAL_TIME {
  if (next.end.kind == 0 || last.end.kind != next.end.kind) return false;
  if (target::isSame(last.end, next.end)) {
    next.carried = last.carried;
  } else if (over_ticks > 0) {
    next.carried = {0, over_ticks, placeNow(last)};
  }
  return next.carried.total > 0;
}

}  // namespace

TickState makeState(const TickProgram& program) {
  TickState state;
  state.needs = program.needs;
  state.entries.resize(program.entries.size());
  for (std::size_t index = 0; index < state.entries.size(); ++index) {
    state.entries[index].target = target::makeState(program.entries[index].constraint.goal);
    state.entries[index].end = target::placingOf(program.entries[index].constraint.goal);
  }
  return state;
}

void reset(TickState& state) noexcept {
  for (EntryState& entry : state.entries) {
    target::reset(entry.target);
    entry.energy = control::EnergyState{};
    entry.follower.begun = false;
    control::reset(entry.law);
  }
  state.bump_T_W.setZero();
  state.retuned = false;
}

bool isValid(const TickState& state, const TickProgram& program) {
  for (std::size_t index = 0; index < program.entries.size(); ++index) {
    const EntryState& entry = state.entries[index];
    if (!isValid(entry.target, program.entries[index].constraint.goal)) return false;
    if (!isValid(entry.energy) || !isValid(entry.follower) || !isValid(entry.law)) return false;
    const Carried& carried = entry.carried;
    if (carried.total == 0) continue;
    if (carried.done < 0 || carried.done >= carried.total || !target::isValid(carried.from, entry.end)) return false;
  }
  const auto isNumber = [](double angle_rad) { return std::isfinite(angle_rad); };
  return isFlag(state.has_time) && isFlag(state.limited) && isFlag(state.retuned) && state.p_WT.allFinite() &&
         std::all_of(state.q_rad.begin(), state.q_rad.end(), isNumber) && isValid(state.gate);
}

std::size_t bytesOf(const TickState& state) {
  const Needs& needs = state.needs;
  std::size_t bytes = sizeof(TickState);
  for (const EntryState& entry : state.entries) {
    bytes += target::bytesOf(entry.target.memory) + (needs.friction ? sizeof entry.target.grip : 0) +
             (needs.energy ? sizeof entry.energy : 0) + (needs.joints ? sizeof entry.follower : 0) +
             (needs.rate ? sizeof entry.law : 0);
  }
  return bytes;
}

void carryOver(const TickState& last, TickState& next, Carry what, std::int64_t over_ticks) noexcept {
  next.time_ns = last.time_ns;
  next.has_time = last.has_time;
  next.p_WT = last.p_WT;
  next.limited = last.limited;
  next.q_rad = last.q_rad;
  next.gate = last.gate;
  if (what == Carry::Arm) return;
  next.asked_T_W = last.asked_T_W;
  next.bump_T_W = last.bump_T_W;
  // A target that is carried moves the force by itself; to smooth its first tick out would be felt as a step of its
  // own.
  next.retuned = last.retuned || over_ticks == 0;
  if (last.entries.size() == next.entries.size()) {
    for (std::size_t index = 0; index < next.entries.size(); ++index) {
      carryEntry(last.needs, last.entries[index], next.needs, next.entries[index]);
      if (carry(last.entries[index], next.entries[index], over_ticks)) next.carries = true;
    }
  }
  if (what != Carry::ArmAndMovedLaws) return;
  for (EntryState& entry : next.entries) {
    entry.law.velocity.has_last = false;
    target::forgetPath(entry.target);
  }
}

void carryOver(const TickProgram& last_program, const TickState& last, const TickProgram& next_program, TickState& next,
               Carry what, std::int64_t over_ticks) noexcept {
  carryOver(last, next, what, over_ticks);
  const arm::Geometry &from = last_program.geometry, &to = next_program.geometry;
  if (!(solvesInTick(from) && solvesInTick(to)) && !(from == to)) next.has_time = false;
}

void carryTargets(TickProgram& program, TickState& state) noexcept {
  if (!state.carries) return;
  state.carries = false;
  for (std::size_t index = 0; index < state.entries.size(); ++index) {
    EntryState& entry = state.entries[index];
    if (entry.carried.total == 0) continue;
    ++entry.carried.done;
    target::put(program.entries[index].constraint.goal, placeNow(entry));
    if (entry.carried.done < entry.carried.total) {
      state.carries = true;
    } else {
      entry.carried = {};
    }
  }
}

}  // namespace underact::tick
