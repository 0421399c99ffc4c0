#pragma once
#include <string>
#include <utility>
#include <vector>

#include "app/cli/command.h"
#include "core/scene/description.h"

namespace underact::cli {

// A setting of a scene from the command line: its path, or its key for all constraints that have it, and its value,
// "kp_N_per_mm=0.8".

/// --set, any number of times.
Option addSet(Command command, std::vector<std::string>& overrides, const std::string& what);

/// The text on both sides of the first =.
std::pair<std::string, std::string> sidesOf(const std::string& text);

/// The scene with all of them, one after the other; whether they are compatible is checked by check(). Problems: those
/// of the first that is invalid.
Result<scene::Description> withOverrides(scene::Description scene, const std::vector<std::string>& overrides);

}  // namespace underact::cli
