#pragma once
#include "core/base/real_time.h"
#include "core/mesh/surface.h"

namespace underact::mesh {

/// The side from which a path passes through a face: Inwards from the side that the normal points to.
enum class CrossingDirection : std::uint8_t { Inwards, Outwards };

/// The first face that the straight path from from_M to to_M passes through; -1: none. Watertight: a path through a
/// shared edge or corner passes through one of the faces, for any rounding. Both ends finite. is_whole is false where
/// very many faces lie along the path, and the rest was not looked at (kMaxVisits).
/// Source: Woop, Benthin and Wald 2013, Watertight ray/triangle intersection.
struct Crossing {
  std::int32_t face = -1;
  bool is_whole = true;
};
/// way: which crossings count. Equal ends: none. Cost: bounded by kMaxVisits.
Crossing firstCrossing(const Surface& surface, CrossingDirection direction, const Vec3& from_M,
                       const Vec3& to_M) noexcept UNDERACT_REAL_TIME;

/// How many more faces the straight path passes through outwards than inwards; of a closed mesh, by how much the
/// winding number at from_M is greater than at to_M. Both ends finite and not on a face. After kMaxVisits, of the
/// faces found so far; a path exactly through an edge counts both faces.
int netCrossings(const Surface& surface, const Vec3& from_M, const Vec3& to_M) noexcept UNDERACT_REAL_TIME;

/// Whether q is inside a closed surface, by the faces that a ray from it passes through. Slower than the sign at the
/// nearest point, but correct where faces nearly touch, so that rounding may have swapped them. q_M: finite. After
/// kMaxVisits, by the faces found so far.
bool isInside(const Surface& surface, const Vec3& q_M) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::mesh
