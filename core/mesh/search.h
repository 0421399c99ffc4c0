#pragma once
#include <cstdint>

#include "core/base/real_time.h"
#include "core/base/search.h"
#include "core/mesh/cut.h"
#include "core/mesh/on_triangle.h"
#include "core/mesh/surface.h"

namespace underact::mesh {

/// See core/base/search.h.
using underact::Search;

/// What a search remembers from tick to tick.
struct SearchState {
  std::int32_t face = -1;  // the nearest one of the last tick; -1: none yet
  Cut cut = {};            // where the last hybrid searches began
};

/// The point of the surface nearest to a point q.
struct Hit {
  Vec3 p_M = Vec3::Zero();
  double squared = kInfinity;  // of the distance
  std::int32_t face = -1;
  Part part = Part::Inside;
  bool is_proved = false;  // proved to be the global minimum
  int visits = 0;          // nodes looked at
};

/// Nodes that one search looks at, at most: it bounds the time where very many faces are nearly equally near (the
/// centre of a sphere). Past it the best point so far counts, and is_proved is false.
inline constexpr int kMaxVisits = 4000;

/// The point of the surface nearest to q_M, any finite point. Where is_proved, exact within 1e-15 of the largest
/// coordinate, for a q_M within 1e6 times the size of the mesh. Local: to the same precision no farther than the face
/// of the last tick, nor than the faces that meet the face of the hit there. Cost: bounded by kMaxVisits.
Hit nearestPoint(const Surface& surface, Search search, const Vec3& q_M,
                 SearchState& state) noexcept UNDERACT_REAL_TIME;

/// The outward direction at a hit: the normal of the face or edge it is on, or the angle-weighted normal of the corner;
/// unit, zero where there is none. Its sign tells inside from outside for any point whose nearest point is the hit.
/// Source: Baerentzen and Aanaes 2005, Signed distance computation using the angle weighted pseudonormal.
Vec3 outwardAt(const Surface& surface, const Hit& hit) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::mesh
