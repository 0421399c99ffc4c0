#pragma once
#include <vector>

#include "core/base/task_monitor.h"
#include "core/mesh_union/boxes.h"
#include "core/mesh_union/points.h"

namespace underact::mesh_union {

/// A face, or a triangle of one that others cut, or of several that lie on each other.
struct Piece {
  std::array<std::int32_t, 3> corners{};  // points
  std::int32_t times = 1;                 // above 0: by how much the winding number is greater behind it
  std::int32_t face = 0;                  // one that it is of
  bool is_cut = false;                    // it is not the whole of that face
};

/// All faces, cut so that no two intersect: they have edges and corners in common, or nothing.
struct Arrangement {
  std::vector<Piece> pieces;
  std::vector<std::int32_t> plane_of;  // of each face: of those that overlap in one plane the first; -1: it has no area
  std::int64_t crossings = 0;          // pairs of faces with more than corners and edges of theirs in common
  bool is_whole = true;                // false: cancelled, or beyond the limits; the pieces are then not to be used
};

/// How much work a mesh may take.
struct Limits {
  std::int64_t pairs = 30'000'000;     // of faces whose boxes meet; some seconds
  std::int64_t crossings = 2'000'000;  // of those that intersect; ten seconds
};

/// Cuts all faces along their lines of intersection. Exact. boxes: of the faces; points: gets the new ones. Not whole:
/// cancelled, or beyond the limits. Source: Zhou, Grinspun, Zorin and Jacobson 2016, Mesh arrangements for solid
/// geometry.
Arrangement arrange(const Grid& grid, const std::vector<mesh::Face>& faces, const Boxes& boxes, Points& points,
                    const TaskMonitor& monitor, const Limits& limits);

}  // namespace underact::mesh_union
