#pragma once
#include "core/mesh_file/repair.h"

namespace underact::mesh_file {

/// Puts the surface of the union in place of a mesh whose faces cross, or whose parts may: see mesh_union::unite(). A
/// mesh of one part that does not cross itself stays as it is, to the bit; so does one that has no inside. The facts
/// say what was done. false: cancelled.
bool uniteRepaired(Repaired& repaired, const TaskMonitor& monitor);

}  // namespace underact::mesh_file
