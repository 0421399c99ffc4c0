#pragma once
#include "app/options/command.h"
#include "core/servo/scheduling.h"

namespace underact::options {

/// --scheduling and --core.
void addSchedulingOptions(Command command, servo::SchedulingWanted& wanted);

}  // namespace underact::options
