#include "app/cli/arm_choice.h"

#include <ostream>

#include "app/cli/scene_file.h"
#include "core/sim/arm_model_file.h"

namespace underact::cli {

Exit refuseArm(const Problems& problems, std::ostream& err) {
  print(problems, err);
  return problems.front().place.file.empty() ? Exit::Usage : exitOf(problems);
}

void addArmOption(Command command, std::string& name) {
  name = std::string(arm::kDefaultArm);
  command.option("--arm", name, "An arm from the list below, or an arm file").showUsual();
}

std::string listOfArms() {
  std::string list = "Arms:";
  for (const arm::Model& model : arm::models()) list += "\n  " + model.name + ": " + model.title;
  return list;
}

void addArmModelOption(Command command, std::string& name) {
  command.option("--arm-model", name, "Model of the simulated arm: a name, or the file of a measured arm")
      .showUsual()
      .check([](const std::string& text) {
        if (text.find_first_of("./\\") != std::string::npos) return std::string();  // a file: read later
        const Result<sim::ArmModel> model = sim::chooseArmModel(text);
        return std::string(model ? Sentence() : model.problems().front().sentence);
      });
}

}  // namespace underact::cli
