#include "core/kinematics/solved_arm.h"

#include <utility>
#include <vector>

#include "core/json/text.h"

namespace underact::kinematics {
namespace {

Result<arm::Model> modelOf(const std::string& name, const arm::UrdfEnds& ends) {
  if (name.find_first_of("./\\") != std::string::npos) return arm::readArmFile(name, ends);
  if (!ends.base.empty() || !ends.tip.empty())
    return Problems{{"--base and --tip are for URDF files: other files have one arm.", {}}};
  if (const arm::Model* const found = arm::findModel(name)) return *found;
  std::vector<std::string> names;
  for (const arm::Model& one : arm::models()) names.push_back(one.name);
  return Problems{{"There is no arm " + json::shown(name) + "; it must be " + json::listed(names) +
                       ", or an arm file (a name with a dot or a slash).",
                   {}}};
}

}  // namespace

SolvedArm solvedArm(arm::Model model) {
  SolvedArm arm{std::move(model), {}, {}, {}, {}};
  arm.omni = arm::omniGeometry(arm.model);
  arm.flange = arm.model.chain;
  arm.inverse = chain::inverseOf(arm.model.chain);
  if (arm.model.rows.size() == 6 && arm.model.form == arm::ArmForm::ModifiedDh)
    arm.flange = chain::chainFromDh(arm.model.rows, arm.model.X_WB, Pose::Identity());
  arm.closed = chain::recognise(arm.model.chain);
  return arm;
}

Result<SolvedArm> chooseArm(const std::string& name, const arm::UrdfEnds& ends) {
  Result<arm::Model> model = modelOf(name, ends);
  if (!model) return model.problems();
  return solvedArm(std::move(model).value());
}

}  // namespace underact::kinematics
