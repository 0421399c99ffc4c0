#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/arm/model.h"
#include "core/json/object_reader.h"

namespace underact::arm {

// Inside the room: the solids of an arm file.

/// The list "solids" of an arm file, if it has one. The model has its joints already.
void readSolids(json::ObjectReader& object, Model& model);
/// The solids as a member of a file, with its comma before it; empty where there are none.
std::string solidsText(const Model& model);

}  // namespace underact::arm
