#include "app/cli/lab.h"

#include "app/cli/command.h"

namespace underact::cli {

void addLab(CLI::App& program, const Streams& streams, Exit& exit) {
  CLI::App* command = program.add_subcommand("lab", "Measurements on models and on the simulated arm");
  command->require_subcommand(1);
  addLabStep(*command, streams, exit);
  addLabSearch(*command, streams, exit);
  addLabModel(*command, streams, exit);
  addLabTrade(*command, streams, exit);
  addLabStability(*command, streams, exit);
  addLabExtremes(*command, streams, exit);
}

}  // namespace underact::cli
