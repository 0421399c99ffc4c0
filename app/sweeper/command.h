#pragma once
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "core/sweep/team.h"

namespace underact::sweep {

/// The grammar of the whole program. streams, team, exit: outlive it.
options::Program makeGrammar(const cli::Streams& streams, Team* team, cli::Exit& exit);

/// The whole program. arguments: without the program's name. team: the ranks it runs in; null: it is alone. Only the
/// leader prints; the other ranks are silent and end with 0.
cli::Exit execute(std::vector<std::string> arguments, const cli::Streams& streams, Team* team);

}  // namespace underact::sweep
