#include "app/cli/arm_choice.h"

#include <ostream>

#include "app/cli/scene_file.h"
#include "core/sim/arm_model_file.h"

namespace underact::cli {

Exit refuseArm(const Problems& problems, std::ostream& err) {
  print(problems, err);
  return problems.front().place.file.empty() ? Exit::Usage : exitOf(problems);
}

void addArmOption(Command command, AskedArm& asked) {
  asked.arm = std::string(arm::kDefaultArm);
  command.option("--arm", asked.arm, "An arm from the list below, or an arm file").showDefault();
  addEndOptions(command, asked.ends);
}

void addEndOptions(Command command, arm::UrdfEnds& ends) {
  command.option("--base", ends.base, "Of a URDF file: the link that stands still; otherwise its root");
  command.option("--tip", ends.tip,
                 "Of a URDF file: the link of the tip; otherwise the end of the way with the most joints");
}

Result<kinematics::SolvedArm> askedArm(const AskedArm& asked, std::ostream& err) {
  Result<kinematics::SolvedArm> arm = kinematics::chooseArm(asked.arm, asked.ends);
  if (arm) printNotes(arm.value().model.notes, err);
  return arm;
}

std::string listOfArms() {
  std::string list = "Arms:";
  for (const arm::Model& model : arm::models()) list += "\n  " + model.name + ": " + model.title;
  return list;
}

void addArmModelOption(Command command, std::string& name) {
  command.option("--arm-model", name, "Model of the simulated arm: a name, or the file of a measured arm")
      .showDefault()
      .check([](const std::string& text) {
        if (text.find_first_of("./\\") != std::string::npos) return std::string();  // a file: read later
        const Result<sim::ArmModel> model = sim::chooseArmModel(text);
        return std::string(model ? Sentence() : model.problems().front().sentence);
      });
}

}  // namespace underact::cli
