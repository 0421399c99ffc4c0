#pragma once
#include "core/mesh_union/keep.h"

namespace underact::mesh_union {

/// Triangles, two at each edge.
struct Solid {
  std::vector<mesh::Face> faces;
  std::vector<std::int32_t> piece_of;                // of each face
  std::vector<std::array<std::int32_t, 2>> between;  // of each corner: it is half way between these points; equal
                                                     // if it is at a point
};

/// Makes a manifold of pieces. Where more than two meet at an edge, or bodies at a corner, each part of the outside
/// between two of them gets its own corners, so that a proxy slides from one piece to the other and not through to
/// another part of the outside. If two such edges would still have both corners in common, one gets a corner in its
/// middle.
Solid solidOf(const std::vector<Piece>& pieces, const Points& points);

}  // namespace underact::mesh_union
