#pragma once
#include "core/mesh_union/points.h"

namespace underact::mesh_union {

/// A face on the grid, with an area.
struct Flat {
  mesh::Face corners{};  // the first of those at the same position
  Plane plane;
};

/// What two faces have in common besides the corners and the edge that they share.
struct Contact {
  bool overlap = false;                      // they are in one plane, and their interiors have points in common
  std::array<std::int32_t, 2> ends{-1, -1};  // points: one is the first, the ends of a segment are both
  std::vector<std::int32_t> touched;  // of two faces in one plane that do not overlap: corners of one on the other
};

/// Exact. points: gets the new ones, where an edge of one passes through the other.
Contact contactOf(const Grid& grid, const Flat& one, const Flat& other, Points& points);

}  // namespace underact::mesh_union
