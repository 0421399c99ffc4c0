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
  std::int32_t face = -1;  // the nearest one then; -1: none yet
  Cut cut = {};            // where the last hybrid searches began
};

/// The point of the surface nearest to a point q.
struct Hit {
  Vec3 p_M = Vec3::Zero();
  double squared = kInfinity;  // of the distance
  std::int32_t face = -1;
  Part part = Part::Inside;
  bool is_proved = false;  // none is nearer, for certain
  int visits = 0;          // nodes looked at
};

/// Nodes that one search looks at, at most: what bounds its time where very many faces are all but equally near (the
/// centre of a sphere). Past it the best so far counts, and is_proved is false.
inline constexpr int kMostVisits = 4000;

/// The point of the surface nearest to q_M, any finite point. Exact in doubles where is_proved: within 1e-15 of the
/// largest coordinate; not from further off than 1e6 of the mesh's sizes. Local: within the same no farther than from
/// the face of the last tick, nor from the faces that meet its own at the hit. Cost: bounded by kMostVisits.
Hit nearestPoint(const Surface& surface, Search search, const Vec3& q_M,
                 SearchState& state) noexcept UNDERACT_REAL_TIME;

/// Which way is out there: the normal of the face or edge that the hit is on, or the normal of the corner weighted by
/// angle; unit, zero where there is none. Its sign tells inside from outside for any point that has the hit as the
/// nearest. Source: Baerentzen and Aanaes 2005, Signed distance computation using the angle weighted pseudonormal.
Vec3 outwardAt(const Surface& surface, const Hit& hit) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::mesh
