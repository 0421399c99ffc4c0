#pragma once
#include <cstdint>
#include <optional>

#include "core/mesh/triangles.h"
#include "core/mesh/watch.h"

namespace underact::mesh_file {

/// Of faces with the same three corners, whichever way round, leaves the first alone; how many went. None: cancelled.
std::optional<std::int64_t> dropDuplicates(mesh::Triangles& triangles, const mesh::Watch& watch);

}  // namespace underact::mesh_file
