#pragma once
#include <string>

#include "core/json/json.h"

namespace underact::json {

/// The value as text on one line, which parse() reads back to the same.
std::string textOf(const Value& value);

}  // namespace underact::json
