#include <iostream>
#include <memory>
#include <streambuf>

#include "app/cli/scene_file.h"
#include "app/sweeper/command.h"
#include "app/sweeper/mpi_team.h"
#include "core/system/current_folder.h"
#include "core/system/descriptor.h"
#include "core/system/signals.h"
#include "core/system/this_process.h"

namespace {

/// Accepts everything and stores nothing.
class Nothing : public std::streambuf {
  int overflow(int message) override { return traits_type::not_eof(message); }
};

}  // namespace

int main(int argc, char** argv) {
  using underact::sweep::Team;
  underact::system::keepOutCurrentFolder();
  underact::system::reportFullFiles();
  std::unique_ptr<Team> team;
  if (underact::sweep::isOneOfTeam()) {
    underact::Result<std::unique_ptr<Team>> joined = underact::sweep::joinTeam();
    if (!joined) {
      underact::cli::print(joined.problems(), std::cerr);
      return static_cast<int>(underact::cli::Exit::Usage);
    }
    team = std::move(joined).value();
  }
  Nothing nothing;
  std::ostream nowhere(&nothing);
  const bool speaks = team == nullptr || team->rank() == 0;
  const underact::cli::Streams streams{std::cin, speaks ? std::cout : nowhere, speaks ? std::cerr : nowhere,
                                       underact::system::isTerminal(underact::system::kErrors)};
  const underact::cli::Exit exit =
      underact::sweep::execute({argv + (argc > 0 ? 1 : 0), argv + argc}, streams, team.get());
  return speaks ? static_cast<int>(exit) : 0;
}
