#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/task_monitor.h"
#include "core/mesh/triangles.h"

namespace underact::mesh_file {

/// Removes all but the first of faces with the same three corners in any order; gives those removed. None: cancelled.
std::optional<std::vector<mesh::Face>> dropDuplicates(mesh::Triangles& triangles, const TaskMonitor& monitor);

}  // namespace underact::mesh_file
