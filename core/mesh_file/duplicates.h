#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/watch.h"
#include "core/mesh/triangles.h"

namespace underact::mesh_file {

/// Of faces with the same three corners, whichever way round, leaves the first alone; those that went. None: cancelled.
std::optional<std::vector<mesh::Face>> dropDuplicates(mesh::Triangles& triangles, const Watch& watch);

}  // namespace underact::mesh_file
