#pragma once
#include <cstdint>
#include <string>

#include "app/cli/command.h"
#include "core/sim/hand_script.h"

namespace underact::cli {

/// What --hand names: a built-in script, or a file. Problems: no such name (the names are in the sentence); those of
/// the file.
Result<sim::HandScript> findHand(const std::string& hand, std::uint64_t seed);

/// The content of the file that --hand names; empty: it names a built-in script.
std::string contentOfHand(const std::string& hand);

/// Usage if a name was meant, else as exitOf().
Exit exitOfHand(const std::string& hand, const Problems& problems);

}  // namespace underact::cli
