#pragma once
#include <iosfwd>
#include <string>

#include "app/cli/command.h"
#include "core/kinematics/solved_arm.h"

namespace underact::cli {

/// Prints why there is no such arm. Usage if no arm has the name; else as exitOf().
Exit refuseArm(const Problems& problems, std::ostream& err);

/// --arm, with its default.
void addArmOption(Command command, std::string& name);

/// "name: title" of every shipped arm, for --help.
std::string listOfArms();

/// --arm-model: one of the simulated arm's models, or a file of one; name holds the default.
void addArmModelOption(Command command, std::string& name);

}  // namespace underact::cli
