#pragma once
#include <cstdint>

#include "core/base/task_monitor.h"
#include "core/mesh/triangles.h"

namespace underact::mesh_file {

/// What crossingsOf() counted.
struct Crossings {
  std::int64_t pairs = 0;
  bool is_whole = false;  // false: too many faces, or too many close to each other; pairs may be too small
};

/// Above this many faces crossings are not looked for.
inline constexpr std::size_t kMaxFacesForCrossings = 200'000;

/// Pairs of faces without a common corner that cross: an edge of one passes through the other. In doubles, without
/// exact arithmetic: a mere touch may count or not. Coplanar faces that overlap count where an edge of one crosses an
/// edge of the other. The work is bounded.
Crossings crossingsOf(const mesh::Triangles& triangles, const TaskMonitor& monitor);

}  // namespace underact::mesh_file
