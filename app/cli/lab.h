#pragma once
#include "app/cli/command.h"

namespace underact::cli {

// The parts of `lab`: each adds its own subcommand. A new one is a line here and in lab.cpp.
void addLabStep(CLI::App& lab, const Streams& streams, Exit& exit);
void addLabSearch(CLI::App& lab, const Streams& streams, Exit& exit);
void addLabModel(CLI::App& lab, const Streams& streams, Exit& exit);
void addLabTrade(CLI::App& lab, const Streams& streams, Exit& exit);
void addLabStability(CLI::App& lab, const Streams& streams, Exit& exit);
void addLabExtremes(CLI::App& lab, const Streams& streams, Exit& exit);

}  // namespace underact::cli
