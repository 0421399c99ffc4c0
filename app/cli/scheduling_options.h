#pragma once
#include "app/cli/command.h"
#include "core/servo/scheduling.h"

namespace underact::cli {

/// --scheduling and --core.
void addSchedulingOptions(CLI::App& command, servo::SchedulingWanted& wanted);

}  // namespace underact::cli
