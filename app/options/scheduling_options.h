#pragma once
#include <CLI/CLI.hpp>

#include "core/servo/scheduling.h"

namespace underact::options {

/// --scheduling and --core.
void addSchedulingOptions(CLI::App& command, servo::SchedulingWanted& wanted);

}  // namespace underact::options
