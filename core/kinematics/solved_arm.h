#pragma once
#include <optional>
#include <string>

#include "core/arm/model.h"
#include "core/arm/urdf.h"
#include "core/chain/inverse.h"

namespace underact::kinematics {

// What the command line and the Python package answer about an arm: lengths in mm, joint values in rad, or mm where the
// joint slides. Both answer with these functions, and so with the same bits.

/// An arm, and its solvers. Made by solvedArm() or chooseArm().
struct SolvedArm {
  arm::Model model;
  std::optional<arm::Geometry> omni;               // the Omni's straight-line code fits
  chain::Chain flange;                             // to the origin of frame 6 of a table of six joints, else to the tip
  chain::Inverse inverse;                          // to the tip; its closed form, where it has one
  std::optional<chain::SphericalWristArm> closed;  // that form, for an arm of six joints with its wrist at the tip
  const chain::Chain& chain() const { return model.chain; }
  std::size_t joints() const { return model.chain.joints.size(); }
};

/// Looks for the solvers of an arm.
SolvedArm solvedArm(arm::Model model);

/// name: that of a shipped arm, or a file (a name with a dot or a slash). ends: of a file in URDF, the links between
/// which the arm lies. Problems: no such arm, with the names that there are; those of the file; ends of another file.
Result<SolvedArm> chooseArm(const std::string& name, const arm::UrdfEnds& ends = {});

}  // namespace underact::kinematics
