#pragma once
#include "core/mesh_union/points.h"

namespace underact::mesh_union {

/// A face on the grid.
struct Flat {
  mesh::Face corners{};  // the first ones at their places
  Plane plane;
};

/// What two faces have in common beyond the corners and the edge that they share.
struct Contact {
  bool overlap = false;                      // they are in one plane, and so are points of both their insides
  std::array<std::int32_t, 2> ends{-1, -1};  // points: of one alone the first, of a segment both
  std::vector<std::int32_t> touched;  // of two faces in one plane that do not overlap: corners of one on the other
};

/// Exact. Both faces have an area.
Contact contactOf(const Grid& grid, const Flat& one, const Flat& other, Points& points);

}  // namespace underact::mesh_union
