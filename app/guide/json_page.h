#pragma once
#include <string>

#include "core/json/json.h"

namespace underact::guide {

/// A JSON value as people read it: two spaces a level; what fits into a line of 120 columns stands in one.
std::string jsonPage(const json::Value& value);

}  // namespace underact::guide
