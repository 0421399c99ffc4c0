#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

#include "core/base/result.h"
#include "core/sweep/kind.h"

namespace underact::sweep {

/// A sweep: its cells, and all that its result depends on.
struct Sweep {
  std::string kind;
  std::uint64_t seed = 0;
  Cells cells;
  std::string header;       // what the result begins with: lines of "# name: value", then the columns
  std::string fingerprint;  // of the header: sweeps with the same have the same result
};

/// Makes a sweep of that kind. Problems: those of the options and of the kind; no cells.
Result<Sweep> makeSweep(const SweepKind& kind, const Options::Values& given, std::uint64_t seed);

/// The seed of a cell: below 2^53, so that a table read as doubles has it exactly. Independent of rank, thread and
/// order.
std::uint64_t seedOf(std::uint64_t sweep_seed, std::size_t cell);

/// The seed that a cell of this sweep is run with: its own, or that of the cell it is paired with.
std::uint64_t seedOf(const Sweep& sweep, std::size_t cell);

/// Runs a cell and gives its line of the result, without the line end. Any thread. Problems: those of the cell; an
/// exception in it.
Result<std::string> rowOf(const Sweep& sweep, std::size_t cell);

/// A problem with a file as a whole.
inline Problems problemAt(const std::string& path, const std::string& sentence) {
  return {{sentence, {path, 0, 0, {}}}};
}

}  // namespace underact::sweep
