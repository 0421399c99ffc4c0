#pragma once
#include <string>
#include <utility>
#include <vector>

#include "app/cli/command.h"
#include "core/scene/description.h"

namespace underact::cli {

// A setting of a scene that the command line asks for: its path, or its key for all constraints that have it, and what
// it is to be, "kp_N_per_mm=0.8".

/// --set, as often as one likes.
Option addSet(Command command, std::vector<std::string>& wishes, const std::string& what);

/// Both sides of its first =.
std::pair<std::string, std::string> sidesOf(const std::string& wish);

/// The scene with all of them, one after the other; whether they go together is for check(). Problems: of the first
/// that is none.
Result<scene::Description> withWishes(scene::Description scene, const std::vector<std::string>& wishes);

}  // namespace underact::cli
