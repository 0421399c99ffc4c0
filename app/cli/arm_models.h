#pragma once
#include <string>

#include "app/cli/command.h"
#include "core/base/result.h"
#include "core/sim/arm_model.h"

namespace underact::cli {

/// --arm-model: one of the simulated arm's models, or a file of one; name holds the default.
void addArmModelOption(Command command, std::string& name);

/// Of that name, or of the file (a name with a dot or a slash).
Result<sim::ArmModel> armModelOf(const std::string& name);

}  // namespace underact::cli
