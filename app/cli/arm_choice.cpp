#include "app/cli/arm_choice.h"

#include <ostream>

#include "app/cli/scene_file.h"
#include "core/json/text.h"
#include "core/sim/arm_model_file.h"

namespace underact::cli {

Result<ArmChoice> chooseArm(const std::string& name) {
  arm::Model model;
  if (name.find_first_of("./\\") != std::string::npos) {
    Result<arm::Model> read = arm::readArmFile(name);
    if (!read) return read.problems();
    model = std::move(read).value();
  } else if (const arm::Model* found = arm::findModel(name)) {
    model = *found;
  } else {
    std::vector<std::string> names;
    for (const arm::Model& one : arm::models()) names.push_back(one.name);
    return Problems{{"There is no arm " + json::shown(name) + "; it must be " + json::listed(names) +
                         ", or an arm file (a name with a dot or a slash).",
                     {}}};
  }
  ArmChoice choice{model, arm::omniGeometry(model), model.chain, chain::inverseOf(model.chain), {}};
  if (model.rows.size() == 6 && model.form == arm::ArmForm::ModifiedDh)
    choice.flange = chain::chainFromDh(model.rows, model.X_WB, Pose::Identity());
  choice.closed = chain::recognise(model.chain);
  return choice;
}

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
