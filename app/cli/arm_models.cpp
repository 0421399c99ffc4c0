#include "app/cli/arm_models.h"

#include "core/sim/arm_model_file.h"

namespace underact::cli {

void addArmModelOption(Command command, std::string& name) {
  command.option("--arm-model", name, "What the simulated arm is made of: a name, or a file of a measured arm")
      .showUsual()
      .check([](const std::string& text) {
        if (text.find_first_of("./\\") != std::string::npos) return std::string();  // a file: read later
        const Result<sim::ArmModel> model = sim::chooseArmModel(text);
        return std::string(model ? Sentence() : model.problems().front().sentence);
      });
}

Result<sim::ArmModel> armModelOf(const std::string& name) {
  return sim::chooseArmModel(name);
}

}  // namespace underact::cli
