#include "app/options/scheduling_options.h"

#include <map>

namespace underact::options {

void addSchedulingOptions(Command command, system::SchedulingWanted& wanted) {
  static const std::map<std::string, system::Way> kWays{{"auto", system::Way::Auto},
                                                        {"fifo", system::Way::Fifo},
                                                        {"rtkit", system::Way::Rtkit},
                                                        {"normal", system::Way::Normal}};
  std::vector<std::string> names;
  for (const auto& [name, way] : kWays) names.push_back(name);
  command
      .option(
          "--scheduling", [&wanted](const std::string& name) { wanted.way = kWays.at(name); },
          "The way to real time; auto tries fifo, then rtkit, then normal")
      .oneOf(names)
      .usual("auto");
  command.option("--core", wanted.core, "The core on which the servo runs; by default an isolated one, or all")
      .range(0, 1023);
}

}  // namespace underact::options
