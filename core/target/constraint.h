#pragma once
#include <cstddef>
#include <variant>

#include "core/base/real_time.h"
#include "core/target/curve_target.h"
#include "core/target/friction.h"
#include "core/target/manipulated.h"
#include "core/target/mesh_target.h"
#include "core/target/shape_target.h"

namespace underact::target {

/// The kinds of targets.
using Goal = std::variant<NearestOnShape, InfluencedShape, MeshPlace, CurvePath, manipulator::Manipulator>;
/// The state of each kind of Goal between ticks, at the same index.
using Memory = std::variant<std::monostate, InfluenceState, MeshState, CurveState, manipulator::State>;

/// What the stylus is held to.
struct Constraint {
  Goal goal;
  Side side = Side::Both;  // of a shape or a mesh
  Friction friction = {};  // of all but a virtual manipulator
};

/// The state of a constraint between ticks. Made by makeState().
struct State {
  Memory memory;  // of the kind of the constraint's goal, always
  Grip grip;
};

/// What a target of some kinds gives besides its position.
struct Details {
  std::size_t kind = 0;  // the index of the kind in Goal
  Angles angles = {};    // of an influenced shape
  Arc arc = {};          // of an influenced shape
  Robot robot = {};      // of a virtual manipulator
};

/// The constraint to the nearest point of a shape, see nearestOn().
Constraint makeConstraint(const shape::Shape& shape, Side side, const Vec3& stiffness);

/// The state before a first tick, of the kind of the goal. May allocate.
State makeState(const Goal& goal);

/// Whether the target depends on the orientation of the stylus.
bool needsOrientation(const Goal& goal);

/// The target for a stylus with its tip at p_WT (m, finite) and the orientation R_WT. dt_s: since the last tick, 0:
/// unknown. details: what another kind has left there is cleared.
Target targetOf(const Constraint& constraint, const Vec3& p_WT, const Mat3& R_WT, double dt_s, State& state,
                Details& details) noexcept UNDERACT_REAL_TIME;

/// Resets the state to that before a first tick.
void reset(State& state) noexcept UNDERACT_REAL_TIME;
/// Copies the state of a target of the same kind; without effect between different kinds. The grip is not part of it.
void carryOver(const Memory& last, Memory& next) noexcept UNDERACT_REAL_TIME;
/// To be called when an edit has moved the target: this is no motion of the hand, and must not lead it through a wall
/// that was elsewhere. The grip is released, since its surface may be gone.
void forgetPath(State& state) noexcept UNDERACT_REAL_TIME;

/// For bytes from a file: whether the state can be used. goal: for which it was made.
bool isValid(const State& state, const Goal& goal);

/// The size of the state of its kind.
std::size_t bytesOf(const Memory& memory);

}  // namespace underact::target
