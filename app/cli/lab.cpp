#include "app/cli/command.h"

namespace underact::cli {

void addLab(Command program, const Streams& streams, Exit& exit) {
  const Command command = program.add("lab", "Measurements on models and on the simulated arm");
  command.mustChoose();
  addLabStep(command, streams, exit);
  addLabSearch(command, streams, exit);
  addLabModel(command, streams, exit);
  addLabTrade(command, streams, exit);
  addLabStability(command, streams, exit);
  addLabExtremes(command, streams, exit);
}

}  // namespace underact::cli
