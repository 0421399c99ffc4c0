#pragma once
#include "core/mesh_file/repair.h"

namespace underact::mesh_file {

/// Replaces a mesh whose faces intersect, or whose parts may, by the surface of the union: see mesh_union::unite(). A
/// mesh of one part that does not intersect itself stays the same to the bit; so does one that has no inside. The facts
/// say what was done. false: cancelled.
bool uniteRepaired(Repaired& repaired, const TaskMonitor& monitor);

}  // namespace underact::mesh_file
