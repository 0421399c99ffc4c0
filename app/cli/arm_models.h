#pragma once
#include <string>

#include "app/cli/command.h"

namespace underact::cli {

/// --arm-model: one of the simulated arm's models; name holds the default.
void addArmModelOption(CLI::App& command, std::string& name);

}  // namespace underact::cli
