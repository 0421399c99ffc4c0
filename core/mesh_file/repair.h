#pragma once
#include <optional>
#include <vector>

#include "core/base/watch.h"
#include "core/mesh/triangles.h"
#include "core/mesh_file/facts.h"

namespace underact::mesh_file {

struct Repaired {
  mesh::Triangles triangles;  // finite; of each face three different corners; corners in order of first use
  Facts facts;
  std::vector<mesh::Face> twice = {};  // that were left out as duplicates, as the file has them
};

/// Corners nearer to each other than this share of the mesh's diagonal become one.
inline constexpr double kWeldShare = 1e-6;

/// Welds corners; leaves out faces that are none or are there twice; turns faces so that neighbours agree and closed
/// parts have their outside out; then looks at what it is. Any triangles, also none. The same for the same, to the bit.
/// None: cancelled. Cost: about linear; measured: 1.4 s for 2 million faces.
std::optional<Repaired> repair(mesh::Triangles triangles, const Watch& watch = {});

}  // namespace underact::mesh_file
