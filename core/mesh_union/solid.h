#pragma once
#include "core/mesh_union/keep.h"

namespace underact::mesh_union {

/// Triangles with corners of their own, of which each edge has two.
struct Solid {
  std::vector<mesh::Face> faces;
  std::vector<std::int32_t> piece_of;                // of each face
  std::vector<std::array<std::int32_t, 2>> between;  // of each corner: the points that it is half way between; alike
                                                     // where it is at a point
};

/// Where more than two pieces meet in an edge, or bodies in a corner, each outside between two of them has corners of
/// its own: a proxy goes from the one piece to the other, and not through to the next outside. Where such an edge would
/// have both its corners in common with another one all the same, it gets a corner in its middle.
Solid solidOf(const std::vector<Piece>& pieces, const Points& points);

}  // namespace underact::mesh_union
