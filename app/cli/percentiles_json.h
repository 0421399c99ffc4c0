#pragma once
#include "app/cli/json_object.h"
#include "core/servo/histogram.h"

namespace underact::cli {

/// {"p50", "p99", "p99.9", "max"}, us; null where a number is not finite.
JsonObject percentilesObject(const servo::Percentiles& values);

}  // namespace underact::cli
