#pragma once
#include <iosfwd>
#include <string>

#include "app/cli/command.h"
#include "core/kinematics/solved_arm.h"

namespace underact::cli {

/// Prints why there is no such arm. Usage if no arm has the name; else as exitOf().
Exit refuseArm(const Problems& problems, std::ostream& err);

/// --arm, with its default; and of a URDF file --base and --tip.
struct AskedArm {
  std::string arm;
  arm::UrdfEnds ends;
};
void addArmOption(Command command, AskedArm& asked);
void addEndOptions(Command command, arm::UrdfEnds& ends);

/// The arm that was asked for; what reading its file chose or left out is printed.
Result<kinematics::SolvedArm> askedArm(const AskedArm& asked, std::ostream& err);

/// "name: title" of every shipped arm, for --help.
std::string listOfArms();

/// --arm-model: one of the simulated arm's models, or a file of one; name holds the default.
void addArmModelOption(Command command, std::string& name);

}  // namespace underact::cli
