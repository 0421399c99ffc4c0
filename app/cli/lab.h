#pragma once
#include "app/cli/command.h"

namespace underact::cli {

// The parts of `lab`: each adds its own subcommand. A new one is a line here and in lab.cpp.
void addLabStep(Command lab, const Streams& streams, Exit& exit);
void addLabSearch(Command lab, const Streams& streams, Exit& exit);
void addLabModel(Command lab, const Streams& streams, Exit& exit);
void addLabTrade(Command lab, const Streams& streams, Exit& exit);
void addLabStability(Command lab, const Streams& streams, Exit& exit);
void addLabExtremes(Command lab, const Streams& streams, Exit& exit);

}  // namespace underact::cli
