#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/arm/follower.h"
#include "core/arm/preset.h"
#include "core/control/law.h"
#include "core/control/passivity.h"
#include "core/safety/gate.h"
#include "core/target/manipulated.h"

namespace underact::tick {

inline constexpr std::size_t kMaxConstraints = 64;

/// How several constraints become one force.
enum class Combine : std::uint8_t { Sum, Nearest };

/// What a tick computes: these quantities and no others. The tip's position is always there.
struct Needs {
  bool orientation = false;  // of the stylus: the wrist (influence, virtual manipulators)
  bool rate = false;         // of the error (PD, PID)
  bool integral = false;     // of the error (PID)
  bool metric = false;       // nearest in the gains' own metric (unequal gains)
  bool choice = false;       // which constraint is nearest (combine: nearest)
  bool robots = false;       // virtual manipulators' joints
  bool meshes = false;       // the last face and the proxy of each mesh
  bool curves = false;       // the last piece and the guide of each curve
  bool friction = false;     // where each target holds on
  bool joints = false;       // the joints that the target asks for, and J_p (space: joint)
  bool energy = false;       // what each constraint was given and gave back (passivity)
  bool motors = false;       // J_p for the gate: the heat of the motors, and the joints' stops
};

/// Where a law works. Cartesian: force from the error, N from m. Joint: torques of joints 1 to 3 from their errors,
/// N m from rad, and the force that these torques put on the tip.
enum class Space : std::uint8_t { Cartesian, Joint };

struct Entry {
  target::Constraint constraint;
  control::Law law;  // in N and m, or in N m and rad, as the space says
  Space space = Space::Cartesian;
  control::Passivity passivity = control::Passivity::Off;
};

/// What a scene compiles to; const from then on, so that any thread may read it. Made by makeProgram().
struct TickProgram {
  Needs needs;
  arm::Geometry geometry;
  arm::JointLimits joint_limits;
  std::vector<Entry> entries;  // 1 to kMaxConstraints
  Combine combine = Combine::Sum;
  safety::Limits limits;
};

/// entries: 1 to kMaxConstraints. The needs follow from the entries.
TickProgram makeProgram(const arm::Geometry& geometry, std::vector<Entry> entries, Combine combine,
                        const safety::Limits& limits, const arm::JointLimits& joint_limits = arm::kNoJointLimits);

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
  std::vector<control::LawState> laws;             // one for each entry; none where no law remembers anything
  std::vector<target::InfluenceState> influences;  // one for each entry; none where the stylus's turn does not count
  std::vector<manipulator::State> robots;          // one for each entry; none where there is no virtual manipulator
  std::vector<target::MeshState> meshes;           // one for each entry; none where there is no mesh
  std::vector<target::CurveState> curves;          // one for each entry; none where there is no curve
  std::vector<target::Grip> grips;                 // one for each entry; none where there is no friction
  std::vector<control::EnergyState> energies;      // one for each entry; none where nobody looks at passivity
  std::vector<arm::FollowerState> followers;       // one for each entry; none where no law works on joints
};

TickState makeState(const TickProgram& program);

/// Of bytes from a file: no index, count, word or flag in it leads the tick of this program out of its memory, and what
/// only finite numbers come of is finite. What a servo was in the midst of always is sound.
bool isSound(const TickState& state, const TickProgram& program);

/// Of the state, all of it.
std::size_t bytesOf(const TickState& state);

/// What another program takes over from the one before it. Arm: time, tip and gate. Laws: also what each law remembers,
/// entry by entry where both have as many, for a change of gains between two ticks; the force goes over to the new ones
/// without a step (see kBumpless_s). MovedLaws: the same, but the way a target went by that change is no rate of the
/// error.
enum class Carry : std::uint8_t { Arm, ArmAndLaws, ArmAndMovedLaws };
void carryOver(const TickState& last, TickState& next, Carry what = Carry::ArmAndLaws) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::tick
