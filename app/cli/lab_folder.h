#pragma once
#include <string>
#include <utility>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/table.h"

namespace underact::cli {

/// The tables by the names of their files, as CSV into the folder, and the pictures of `underact-cli lab KIND` beside
/// them. A table without rows has no file. Failures are printed.
Exit fillFolder(const std::string& folder, const std::string& kind,
                const std::vector<std::pair<std::string, const Table*>>& tables, const Streams& streams);

}  // namespace underact::cli
