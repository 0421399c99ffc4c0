#pragma once
#include "app/options/command.h"
#include "core/system/scheduling.h"

namespace underact::options {

/// --scheduling and --core.
void addSchedulingOptions(Command command, system::SchedulingRequest& wanted);

}  // namespace underact::options
