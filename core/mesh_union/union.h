#pragma once
#include <cstdint>

#include "core/base/task_monitor.h"
#include "core/mesh/triangles.h"
#include "core/mesh_union/arrange.h"

namespace underact::mesh_union {

/// What became of a mesh.
enum class Outcome : std::uint8_t {
  AsItWas,  // no two faces intersect, and none is inside a body: unchanged
  Made,     // the surface of the union
  Open,     // the faces do not close, so there is no inside: unchanged
  TooMuch,  // more intersections than the limit: unchanged
  Cancelled,
};

/// What unite() did.
struct Union {
  Outcome outcome = Outcome::AsItWas;
  std::int64_t crossings = 0;  // so far: pairs of faces that have more in common than corners and edges of the mesh
  std::int64_t dropped = 0;    // faces that were inside bodies
};

/// Replaces a mesh that intersects itself, or whose parts intersect, by the surface of the union. Inside is where the
/// winding number is above 0: a shell inside another is a cavity if its faces point inwards; otherwise it is left out.
/// triangles: each of three different corners. If some edge is not used as often in one direction as in the other, the
/// outcome is Open; parts may touch, and faces may lie on each other. Changed only if the outcome is Made: then each
/// edge has two faces, corners of the mesh keep their position to the bit, and new ones are within two floats of the
/// intersection of their planes. Which faces intersect where, and what is inside, is decided exactly on a grid of 6e-8
/// of the extent; what is shorter or narrower than `least` is then merged. wide: how far faces are moved outwards for
/// these decisions, so that narrow unintended gaps between bodies close: see widen(); corners of the mesh stay where
/// they are. least, wide: in the unit of the mesh. Deterministic to the bit. Cost: about 10 us
/// for each intersection, besides the search for them. Sources: Zhou et al. 2016, Mesh arrangements for solid geometry;
/// Jacobson et al. 2013, for the winding number.
Union unite(mesh::Triangles& triangles, double min, double wide, const TaskMonitor& monitor, const Limits& limits = {});

}  // namespace underact::mesh_union
