#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/arm/follower.h"
#include "core/control/law.h"
#include "core/control/passivity.h"
#include "core/safety/gate.h"
#include "core/tick/program.h"

namespace underact::tick {

/// What is remembered of one entry of the program. What the program does not need stays as it was made, untouched.
struct EntryState {
  target::State target;         // grip: needs.friction
  control::EnergyState energy;  // needs.energy
  arm::FollowerState follower;  // needs.joints
  control::LawState law;        // needs.rate; last, since it is long
};

/// All memory there is between two ticks. Made by makeState(), outside the tick.
struct TickState {
  std::int64_t time_ns = 0;
  bool has_time = false;
  Vec3 p_WT = Vec3::Zero();       // the last tip that was known
  arm::JointAngles q_rad{};       // the last sample's joints
  bool limited = false;           // the gate cut or ramped the last force
  Vec3 asked_T_W = Vec3::Zero();  // the last force before the gate
  Vec3 bump_T_W = Vec3::Zero();   // what is left of the step that a change of gains would have made
  bool retuned = false;           // gains or targets were changed since the last tick
  safety::GateState gate;
  Needs needs;                      // the program's
  std::vector<EntryState> entries;  // one for each of the program's
};

/// The memory of a program before its first tick. Allocates; outside the tick.
TickState makeState(const TickProgram& program);

/// As on a first tick: what laws and targets remember. Time, tip and gate stay.
void forget(TickState& state) noexcept UNDERACT_REAL_TIME;

/// Of bytes from a file: no index, count, word or flag in it leads the tick of this program out of its memory, and what
/// only finite numbers come of is finite. What a servo was in the midst of always is sound.
bool isSound(const TickState& state, const TickProgram& program);

/// Of what the program needs of the state.
std::size_t bytesOf(const TickState& state);

/// What another program takes over from the one before it. Arm: time, tip and gate. Laws: also what each law remembers,
/// entry by entry where both have as many, for a change of gains between two ticks; the force goes over to the new ones
/// without a step (see kBumpless_s). MovedLaws: the same, but the way a target went by that change is no rate of the
/// error.
enum class Carry : std::uint8_t { Arm, ArmAndLaws, ArmAndMovedLaws };
/// Into a next that makeState() has just made for its program.
void carryOver(const TickState& last, TickState& next, Carry what = Carry::ArmAndLaws) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::tick
