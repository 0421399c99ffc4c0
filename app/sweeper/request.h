#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "app/cli/command.h"
#include "core/sweep/kind.h"
#include "core/sweep/team.h"

namespace underact::sweep {

/// The request on the command line.
struct Request {
  const SweepKind* kind = nullptr;
  Options::Values values;
  std::uint64_t seed = 1;
  std::string out;
  int threads = 0;  // 0: all cores; of a rank, one
  bool dry_run = false;
  bool print = false;       // the commands of the cells, instead of running them
  std::optional<int> cell;  // of print: only this one
  bool quiet = false;
  Problems problems = {};  // with the file it was to be read from
};

/// {"underact_sweep": 1, "kind": "hands", "seed": 1, "options": {"scene": ["a.json"], "draws": 10}}: sets kind, seed
/// and values; or all problems at once, with their places.
void readRequest(const std::string& path, Request& request);

/// Runs the sweep, or measures how long it would take, or prints the commands of its cells.
cli::Exit runSweep(const Request& request, const cli::Streams& streams, Team* team);

}  // namespace underact::sweep
