#include "app/options/scheduling_options.h"

#include <map>

namespace underact::options {

void addSchedulingOptions(Command command, system::SchedulingRequest& wanted) {
  static const std::map<std::string, system::SchedulingMethod> kMethods{{"auto", system::SchedulingMethod::Auto},
                                                                        {"fifo", system::SchedulingMethod::Fifo},
                                                                        {"rtkit", system::SchedulingMethod::Rtkit},
                                                                        {"normal", system::SchedulingMethod::Normal}};
  std::vector<std::string> names;
  for (const auto& [name, method] : kMethods) names.push_back(name);
  command
      .option(
          "--scheduling", [&wanted](const std::string& name) { wanted.method = kMethods.at(name); },
          "The way to real time; auto tries fifo, then rtkit, then normal")
      .oneOf(names)
      .defaultText("auto");
  command.option("--core", wanted.core, "The core on which the servo runs; by default an isolated one, or all")
      .range(0, 1023);
}

}  // namespace underact::options
