#pragma once
#include <cstdint>
#include <optional>

#include "core/base/watch.h"
#include "core/mesh/triangles.h"

namespace underact::mesh_file {

/// Of faces with the same three corners, whichever way round, leaves the first alone; how many went. None: cancelled.
std::optional<std::int64_t> dropDuplicates(mesh::Triangles& triangles, const Watch& watch);

}  // namespace underact::mesh_file
