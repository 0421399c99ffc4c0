#pragma once
#include <cstdint>
#include <optional>

#include "core/base/task_monitor.h"
#include "core/mesh/triangles.h"

namespace underact::mesh_file {

struct ClosedHoles {
  std::int64_t count = 0;
  double longest = 0.0;  // way around one, in the mesh's unit
};

/// A hole that is longer around than this share of the mesh's diagonal is none that somebody forgot.
inline constexpr double kLongestHole = 0.3;
/// Nor are holes whose faces would be more than this share of the mesh's area.
inline constexpr double kMostOfArea = 0.05;

/// Closes small holes, each by triangles from its middle to its border: with them the faces go around each edge as
/// often one way as the other, so that the winding number is whole everywhere. Where the mesh had none it is that of
/// the surface without the faces, rounded, but for points within the hole itself. None: a hole is too large, or it was
/// cancelled; then the mesh is as it was.
std::optional<ClosedHoles> closeHoles(mesh::Triangles& triangles, const TaskMonitor& monitor);

}  // namespace underact::mesh_file
