#pragma once
#include "core/json/object_text.h"

namespace underact::cli {

/// One answer of the command line.
using JsonObject = json::ObjectText;

}  // namespace underact::cli
