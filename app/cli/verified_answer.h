#pragma once
#include "app/cli/command.h"
#include "app/cli/json_object.h"
#include "core/record/replay.h"

namespace underact::cli {

/// Adds the first difference to the answer, if there is one, and which mended laws may be why; says so on stderr.
/// Whether all ticks are the same to the last bit.
bool addDifference(JsonObject& answer, const record::Verified& verified, const Streams& streams);

}  // namespace underact::cli
