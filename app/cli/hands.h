#pragma once
#include <cstdint>
#include <string>

#include "app/cli/command.h"
#include "core/sim/hand_script.h"

namespace underact::cli {

/// What --hand names: a built-in script, or a file. Problems: no such name (the names are in the sentence); those of
/// the file.
Result<sim::HandScript> findHand(const std::string& hand, std::uint64_t seed);

/// Usage if a name was meant, else as exitOf().
Exit exitOfHand(const std::string& hand, const Problems& problems);

}  // namespace underact::cli
