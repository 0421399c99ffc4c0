#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/task_monitor.h"
#include "core/mesh/triangles.h"

namespace underact::mesh_file {

/// For each corner, the index of the first corner that it is merged with: its own where there is none before it.
/// Corners within the tolerance of a first one are merged with it; with the nearest of several, the first of equally
/// near ones. tolerance: 0 merges equal corners alone. p_MV: finite. None: cancelled.
std::optional<std::vector<std::int32_t>> weld(const std::vector<Eigen::Vector3f>& p_MV, double tolerance,
                                              const TaskMonitor& monitor);

}  // namespace underact::mesh_file
