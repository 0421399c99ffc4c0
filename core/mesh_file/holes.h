#pragma once
#include <cstdint>
#include <optional>

#include "core/base/task_monitor.h"
#include "core/mesh/triangles.h"

namespace underact::mesh_file {

/// What closeHoles() closed.
struct ClosedHoles {
  std::int64_t count = 0;
  double longest = 0.0;  // length of a border, in the unit of the mesh
};

/// Holes with a border longer than this share of the mesh's diagonal are taken as intended.
inline constexpr double kLongestHole = 0.3;
/// So are holes that need faces of more than this share of the mesh's area.
inline constexpr double kMaxOfArea = 0.05;

/// Closes small holes by triangles from the middle of each to its border: then each edge is used as often in one
/// direction as in the other, so the winding number is an integer everywhere. Except for points in the hole itself, it
/// is the generalised winding number of the open mesh, rounded. None: a hole is too large, or cancelled; the mesh is
/// then unchanged.
std::optional<ClosedHoles> closeHoles(mesh::Triangles& triangles, const TaskMonitor& monitor);

}  // namespace underact::mesh_file
