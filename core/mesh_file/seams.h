#pragma once
#include <cstdint>
#include <optional>

#include "core/mesh_file/edges.h"

namespace underact::mesh_file {

/// Divides faces at the corners of other faces that lie on their borders (T-junctions): two sides of a seam with
/// different corners have no area between them, so that is no hole. triangles: welded; each of three different corners.
/// tolerance: how far from the border a corner may be. Gives how many faces were added; 0: the mesh is as it was, also
/// where no seam would close or an edge would have more than two faces, or where there are too many to compare. edges:
/// those of the mesh, before and after. None: cancelled.
std::optional<std::int64_t> divideAtSeams(mesh::Triangles& triangles, Edges& edges, double tolerance,
                                          const TaskMonitor& monitor);

}  // namespace underact::mesh_file
