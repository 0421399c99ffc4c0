#pragma once
#include <iosfwd>
#include <optional>
#include <string>

#include "app/cli/command.h"
#include "core/arm/model.h"
#include "core/chain/inverse.h"

namespace underact::cli {

/// An arm, and its solvers.
struct ArmChoice {
  arm::Model model;
  std::optional<arm::Geometry> omni;               // the Omni's straight-line code fits
  chain::Chain flange;                             // to the origin of frame 6 of a table of six joints, else to the tip
  chain::Inverse inverse;                          // to the tip; its closed form, where it has one
  std::optional<chain::SphericalWristArm> closed;  // that form, for an arm of six joints with its wrist at the tip
  /// To the tip.
  const chain::Chain& chain() const { return model.chain; }
  std::size_t joints() const { return model.chain.joints.size(); }
};

/// name: that of a shipped arm, or a file (a name with a dot or a slash).
Result<ArmChoice> chooseArm(const std::string& name);

/// Prints why there is no such arm. Usage if no arm has the name; else as exitOf().
Exit refuseArm(const Problems& problems, std::ostream& err);

/// --arm, with its default.
void addArmOption(Command command, std::string& name);

/// "name: title" of every shipped arm, for --help.
std::string listOfArms();

/// --arm-model: one of the simulated arm's models, or a file of one; name holds the default.
void addArmModelOption(Command command, std::string& name);

}  // namespace underact::cli
