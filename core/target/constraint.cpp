#include "core/target/constraint.h"

#include <utility>

namespace underact::target {
namespace {

static_assert(std::variant_size_v<Goal> == std::variant_size_v<Memory>);

// std::visit may throw, which clang's analysis of the tick refuses: the kind is selected by std::get_if.

Target influencedTarget(const InfluencedShape& held, const Vec3& p_WT, const Vec3& stylus_W, double dt_s,
                        InfluenceState& state, Details& details) noexcept UNDERACT_REAL_TIME {
  const Influenced found = influencedTarget(held.shape, held.influence, p_WT, stylus_W, dt_s, state);
  details.angles = found.angles;
  details.arc = found.arc;
  return {found.p_WP, found.is_unique ? Status::Unique : Status::Degenerate, found.distance_m};
}

/// The target without friction and smoothing of normals.
Target smoothTarget(const Constraint& constraint, const Vec3& p_WT, const Mat3& R_WT, double dt_s, Memory& memory,
                    Details& details) noexcept UNDERACT_REAL_TIME {
  const Goal& goal = constraint.goal;
  if (const auto* held = std::get_if<NearestOnShape>(&goal)) return nearestTarget(*held, constraint.side, p_WT);
  if (const auto* held = std::get_if<InfluencedShape>(&goal))
    return influencedTarget(*held, p_WT, R_WT.col(2), dt_s, *std::get_if<InfluenceState>(&memory), details);
  if (const auto* place = std::get_if<MeshPlace>(&goal))
    return meshTarget(*place, constraint.side, p_WT, *std::get_if<MeshState>(&memory));
  if (const auto* path = std::get_if<CurvePath>(&goal))
    return curveTarget(*path, p_WT, dt_s, *std::get_if<CurveState>(&memory));
  return manipulatedTarget(*std::get_if<manipulator::Manipulator>(&goal), p_WT, R_WT, dt_s,
                           *std::get_if<manipulator::State>(&memory), details.robot);
}

/// p_WG, which slid from p_WP, put back onto the constraint.
Vec3 onto(const Goal& goal, const Memory& memory, const Vec3& p_WG, const Vec3& p_WP) noexcept UNDERACT_REAL_TIME {
  if (const auto* held = std::get_if<NearestOnShape>(&goal)) return ontoShape(*held, p_WG, p_WP);
  if (const auto* held = std::get_if<InfluencedShape>(&goal)) return ontoShape(*held, p_WG, p_WP);
  if (const auto* place = std::get_if<MeshPlace>(&goal))
    return ontoMesh(*place, *std::get_if<MeshState>(&memory), p_WG);
  if (const auto* path = std::get_if<CurvePath>(&goal))
    return ontoCurve(*path, *std::get_if<CurveState>(&memory), p_WG);
  return p_WP;
}

/// The point to which friction holds the target. smooth: the target without friction.
Vec3 heldPoint(const Constraint& constraint, const Vec3& p_WT, const Target& smooth, double dt_s,
               State& state) noexcept UNDERACT_REAL_TIME {
  Grip& grip = state.grip;
  if (smooth.status != Status::Unique) {
    grip.hold = Hold::None;
    return smooth.p_WP;
  }
  if (slides(constraint.friction, p_WT, smooth.p_WP, dt_s, grip))
    grip.p_WG = onto(constraint.goal, state.memory, grip.p_WG, smooth.p_WP);
  return grip.p_WG;
}

template <class Part>
void makeAnew(Part* part) noexcept UNDERACT_REAL_TIME {
  if (part != nullptr) *part = Part{};
}
template <class... Parts>
void makeAnew(std::variant<Parts...>& memory) noexcept UNDERACT_REAL_TIME {
  (makeAnew(std::get_if<Parts>(&memory)), ...);
}

template <class Part>
void copy(const Part* last, Part* next) noexcept UNDERACT_REAL_TIME {
  if (last != nullptr && next != nullptr) *next = *last;
}
template <class... Parts>
void copy(const std::variant<Parts...>& last, std::variant<Parts...>& next) noexcept UNDERACT_REAL_TIME {
  (copy(std::get_if<Parts>(&last), std::get_if<Parts>(&next)), ...);
}

template <std::size_t... kinds>
Memory memoryOf(std::size_t kind, std::index_sequence<kinds...>) {
  Memory memory;
  ((kind == kinds ? static_cast<void>(memory.emplace<kinds>()) : static_cast<void>(0)), ...);
  return memory;
}

}  // namespace

Constraint makeConstraint(const shape::Shape& shape, Side side, const Vec3& stiffness) {
  return {nearestOn(shape, stiffness), side};
}

State makeState(const Goal& goal) {
  return {memoryOf(goal.index(), std::make_index_sequence<std::variant_size_v<Memory>>()), {}};
}

bool needsOrientation(const Goal& goal) {
  const auto* robot = std::get_if<manipulator::Manipulator>(&goal);
  return std::holds_alternative<InfluencedShape>(goal) ||
         (robot != nullptr && robot->orientation != manipulator::Orientation::None);
}

Target targetOf(const Constraint& constraint, const Vec3& p_WT, const Mat3& R_WT, double dt_s, State& state,
                Details& details) noexcept {
  const Goal& goal = constraint.goal;
  if (details.kind !=
      goal.index()) {  // each kind fills in all of its own; details of another kind may be left from before
    details = Details{};
    details.kind = goal.index();
  }
  Target target = smoothTarget(constraint, p_WT, R_WT, dt_s, state.memory, details);
  Vec3 lean_W = Vec3::Zero();
  if (const auto* place = std::get_if<MeshPlace>(&goal); place != nullptr && target.status == Status::Unique)
    lean_W = shadingOffset(*place, *std::get_if<MeshState>(&state.memory), p_WT, target.p_WP);
  if (constraint.friction.isThere()) target.p_WP = heldPoint(constraint, p_WT, target, dt_s, state);
  target.p_WP += lean_W;
  return target;
}

void reset(State& state) noexcept {
  makeAnew(state.memory);
  state.grip.hold = Hold::None;
}

void carryOver(const Memory& last, Memory& next) noexcept {
  copy(last, next);
}

void forgetPath(State& state) noexcept {
  if (auto* mesh = std::get_if<MeshState>(&state.memory)) mesh->touch.knows_last = false;
  state.grip.hold = Hold::None;
}

bool isValid(const State& state, const Goal& goal) {
  const Memory& memory = state.memory;
  if (memory.index() != goal.index() || !isValid(state.grip)) return false;
  if (const auto* influence = std::get_if<InfluenceState>(&memory)) return isValid(*influence);
  if (const auto* robot = std::get_if<manipulator::State>(&memory)) return isValid(*robot);
  if (const auto* mesh = std::get_if<MeshState>(&memory)) return isValid(*mesh, *std::get<MeshPlace>(goal).surface);
  if (const auto* curve = std::get_if<CurveState>(&memory)) return isValid(*curve, *std::get<CurvePath>(goal).curve);
  return true;
}

std::size_t bytesOf(const Memory& memory) {
  return std::visit(
      [](const auto& part) { return std::is_empty_v<std::decay_t<decltype(part)>> ? std::size_t{0} : sizeof part; },
      memory);
}

}  // namespace underact::target
