#pragma once
#include "core/base/sentence.h"
#include "core/mesh_file/facts.h"

namespace underact::mesh_file {

/// That the surface intersects itself, and what is felt there; or that bodies were united which do not cross. Empty:
/// neither.
Sentence crossingReport(const Facts& facts);

}  // namespace underact::mesh_file
