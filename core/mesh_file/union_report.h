#pragma once
#include "core/base/sentence.h"
#include "core/mesh_file/facts.h"

namespace underact::mesh_file {

/// That the surface intersects itself, and what is felt there; or that parts were united that only touch or contain
/// each other. Empty: neither.
Sentence crossingReport(const Facts& facts);

}  // namespace underact::mesh_file
