#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/arm/follower.h"
#include "core/control/law.h"
#include "core/control/passivity.h"
#include "core/safety/gate.h"
#include "core/target/placing.h"
#include "core/tick/program.h"

namespace underact::tick {

/// A target that is being carried from one place to another, tick by tick.
struct Carried {
  std::int64_t done = 0, total = 0;  // ticks; total 0: it stands where the program has it
  target::Placing from = {};
};

/// The state of one entry of the program. Parts that the program does not need stay untouched.
struct EntryState {
  target::State target;         // grip: needs.friction
  control::EnergyState energy;  // needs.energy
  arm::FollowerState follower;  // needs.joints
  target::Placing end;          // where the program has its target
  Carried carried;              // on the way there; TickState::carries
  control::LawState law;        // needs.rate; last, since it is long
};

/// The whole state between two ticks. Made by makeState(), outside the tick.
struct TickState {
  std::int64_t time_ns = 0;
  bool has_time = false;
  Vec3 p_WT = Vec3::Zero();       // the last known tip
  arm::JointAngles q_rad{};       // the last sample's joints
  bool limited = false;           // the gate cut or ramped the last force
  Vec3 asked_T_W = Vec3::Zero();  // the last force before the gate
  Vec3 bump_T_W = Vec3::Zero();   // what is left of the step that a change of gains would have made
  bool retuned = false;           // gains or targets were changed since the last tick
  bool carries = false;           // a target is on its way
  safety::GateState gate;
  Needs needs;                      // the program's
  std::vector<EntryState> entries;  // one for each of the program's
};

/// The state of a program before its first tick. Allocates; outside the tick.
TickState makeState(const TickProgram& program);

/// Resets laws and targets to the state before a first tick. Time, tip and gate stay.
void reset(TickState& state) noexcept UNDERACT_REAL_TIME;

/// For bytes from a file: whether no index, count or flag in it can lead a tick of this program out of bounds, and
/// everything that is always finite is finite. The state of a running servo is always sound.
bool isValid(const TickState& state, const TickProgram& program);

/// The size of the parts that the program needs.
std::size_t bytesOf(const TickState& state);

/// What another program takes over from the last one. Arm: time, tip and gate. ArmAndLaws: also the state of each law,
/// entry by entry where both have as many, for a change of gains between two ticks; the force changes without a step
/// (see kBumpless_s). ArmAndMovedLaws: the same, but the displacement of a target by that change does not count as a
/// rate of the error.
enum class Carry : std::uint8_t { Arm, ArmAndLaws, ArmAndMovedLaws };
/// Carries the state over to next, which makeState() has just made for its program. over_ticks: above 0, the targets
/// that next has elsewhere go there from where they are now, within so many ticks (carryTargets()), where their kind
/// can be carried; a target on its way to a place that stays the same goes on.
void carryOver(const TickState& last, TickState& next, Carry what = Carry::ArmAndLaws,
               std::int64_t over_ticks = 0) noexcept UNDERACT_REAL_TIME;
/// Carries over between two programs. Where they are for two arms of which one does not solvesInTick(), the tip's last
/// position means nothing to the next: the way between the two is no motion.
void carryOver(const TickProgram& last_program, const TickState& last, const TickProgram& next_program, TickState& next,
               Carry what, std::int64_t over_ticks = 0) noexcept UNDERACT_REAL_TIME;

/// Before each tick: puts the targets that are being carried where they are in this tick. program: the caller's own.
void carryTargets(TickProgram& program, TickState& state) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::tick
