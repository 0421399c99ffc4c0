#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "core/tradeoff/table.h"

namespace underact::cli {

// The inputs of a lab. Empty: one of them could not be read; the problem has been printed, and exit is its status.

/// Scene files with their meshes; no file: those that ship.
std::optional<std::vector<tradeoff::NamedScene>> labScenes(const std::vector<std::string>& files,
                                                           const Streams& streams, Exit& exit);

/// Built-in hands and files; no name: all that are built in.
std::optional<std::vector<tradeoff::NamedHand>> labHands(const std::vector<std::string>& names, std::uint64_t seed,
                                                         const Streams& streams, Exit& exit);

}  // namespace underact::cli
