#pragma once
#include <cstdint>

#include "core/base/watch.h"
#include "core/mesh/triangles.h"

namespace underact::mesh_file {

/// What crossingsOf() counted.
struct Crossings {
  std::int64_t pairs = 0;
  bool is_whole = false;  // false: too many faces, or too many that are near each other; then pairs may be too few
};

/// Above this many faces it is not looked for.
inline constexpr std::size_t kMostFacesForCrossings = 200'000;

/// Pairs of faces, without a corner in common, that go through each other: an edge of one through the
/// other. In doubles, without exact arithmetic: a touch may count either way. Faces in one plane that overlap count
/// where an edge of one crosses an edge of the other. Work bounded.
Crossings crossingsOf(const mesh::Triangles& triangles, const Watch& watch);

}  // namespace underact::mesh_file
