#pragma once
#include <cstdint>

#include "core/mesh/triangles.h"

namespace underact::mesh_union {

/// Which faces and corners were made by cutting, and may change: 1 for these, else 0.
struct Made {
  std::vector<std::uint8_t> faces, corners;
};

/// Removes what is so short or narrow that rounding to floats could turn it over. Edges shorter than `least` are
/// collapsed; the longest edge of triangles with a smaller height is flipped, and so is the edge between two triangles
/// that lie on each other with less than `least` between them. Corners that are not marked do not move, the others by a
/// few `least` at most; each edge keeps two faces. least: in the unit of the mesh.
void tidy(mesh::Triangles& triangles, const Made& made, double min);

}  // namespace underact::mesh_union
