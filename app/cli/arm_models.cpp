#include "app/cli/arm_models.h"

#include "core/sim/arm_model.h"

namespace underact::cli {

void addArmModelOption(CLI::App& command, std::string& name) {
  std::vector<std::string> names;
  for (const sim::ArmModel& model : sim::armModels()) names.emplace_back(model.name);
  command.add_option("--arm-model", name, "What the simulated arm is made of")
      ->capture_default_str()
      ->check(CLI::IsMember(names));
}

}  // namespace underact::cli
