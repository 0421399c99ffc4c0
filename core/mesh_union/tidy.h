#pragma once
#include <cstdint>

#include "core/mesh/triangles.h"

namespace underact::mesh_union {

/// Takes away what is so short or narrow that rounding to floats could turn it over: edges shorter than `least` are
/// drawn together, of triangles that are lower the longest edge goes to the other diagonal, and so does the edge
/// between two that lie on each other with less than that between them. Nothing moves by more than some of `least`.
/// Begins at the faces that are marked, and moves no corner that is not; each edge keeps two faces.
struct Made {
  std::vector<std::uint8_t> faces, corners;
};
void tidy(mesh::Triangles& triangles, const Made& made, double least);

}  // namespace underact::mesh_union
