#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/arm/mechanism.h"
#include "core/arm/preset.h"
#include "core/control/law.h"
#include "core/control/passivity.h"
#include "core/safety/gate.h"
#include "core/target/constraint.h"

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
  bool joints = false;       // the joint angles of the target, and J_p (space: joint)
  bool energy = false;       // the energy of each constraint (passivity)
  bool motors = false;       // J_p for the gate: the heat of the motors, and the joints' stops
  bool more_joints = false;  // the arm has more than six
  bool moment = false;       // of virtual robots, on an arm whose motors render it
  bool more_motors = false;  // the heat of more than three, and the moment
};

/// The space of a law. Cartesian: force from the error, N from m. Joint: torques of joints 1 to 3 from their errors, N
/// m from rad, and the force that these torques put on the tip.
enum class Space : std::uint8_t { Cartesian, Joint };

/// A constraint of the program with the law that holds the stylus to it.
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
  arm::Watched watched = {};
};

/// entries: 1 to kMaxConstraints. The needs follow from the entries.
TickProgram makeProgram(const arm::Geometry& geometry, std::vector<Entry> entries, Combine combine,
                        const safety::Limits& limits, const arm::JointLimits& joint_limits = arm::kNoJointLimits);

}  // namespace underact::tick
