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

/// The kinds of targets, and what each remembers from tick to tick: one list beside the other.
using Goal = std::variant<NearestOnShape, InfluencedShape, MeshPlace, CurvePath, manipulator::Manipulator>;
/// What each kind of Goal remembers, at the same index.
using Memory = std::variant<std::monostate, InfluenceState, MeshState, CurveState, manipulator::State>;

/// What the stylus is held to.
struct Constraint {
  Goal goal;
  Side side = Side::Both;  // of a shape or a mesh
  Friction friction = {};  // of all but a virtual manipulator
};

/// All that it remembers. Made by makeState().
struct State {
  Memory memory;  // of the kind of the constraint's goal, always
  Grip grip;
};

/// What a target of some kinds tells beside its place.
struct Details {
  std::size_t kind = 0;  // which one of Goal's told it
  Angles angles = {};    // of an influenced shape
  Arc arc = {};          // of an influenced shape
  Robot robot = {};      // of a virtual manipulator
};

/// To the point of a shape that is nearest, see nearestOn().
Constraint makeConstraint(const shape::Shape& shape, Side side, const Vec3& stiffness);

/// A state as on a first tick, its memory of the kind of the goal. May allocate.
State makeState(const Goal& goal);

/// Whether the stylus's turn has a part in the target.
bool asksForTurn(const Goal& goal);

/// Where the constraint draws a stylus whose tip is in p_WT (m, finite), turned by R_WT. dt_s: since the last tick, 0:
/// unknown. details: what stands there of another kind goes.
Target targetOf(const Constraint& constraint, const Vec3& p_WT, const Mat3& R_WT, double dt_s, State& state,
                Details& details) noexcept UNDERACT_REAL_TIME;

/// As on a first tick.
void forget(State& state) noexcept UNDERACT_REAL_TIME;
/// What a target of the same kind remembers goes over to the next one. The grip stays out of it.
void carryOver(const Memory& last, Memory& next) noexcept UNDERACT_REAL_TIME;
/// The target was moved by an edit, and that way is none of the hand's: it leads through no wall that was elsewhere.
/// And where a target held on, its surface may be no longer.
void forgetWay(State& state) noexcept UNDERACT_REAL_TIME;

/// Of bytes from a file. goal: that the state was made for.
bool isSound(const State& state, const Goal& goal);

/// Of what the kind remembers.
std::size_t bytesOf(const Memory& memory);

}  // namespace underact::target
