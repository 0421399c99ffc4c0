#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/sweep/options.h"
#include "core/sweep/row.h"

namespace underact::sweep {

/// The independent cells that a kind made of its options, ready to run.
struct Cells {
  std::size_t count = 0;
  std::vector<std::string> columns;  // of a row, without the cell's number and seed, which every result begins with
  /// The files that were read and a checksum of each, as checksumOf() gives it (core/sweep/build.h): a sweep that is
  /// continued with other contents would mix the two.
  std::vector<std::pair<std::string, std::string>> files;
  /// Runs one cell. A function of index (below count) and seed alone: independent of clock, thread, rank and order of
  /// calls. Called by several threads at once, so it must not change what they share. Problems end the sweep; a failure
  /// within a simulation (a fault, a limit that was not found) is a result and belongs in the row.
  std::function<Result<SweepRow>(std::size_t index, std::uint64_t seed)> run;
  /// The command that makes a cell's row again on its own, for a shell; it gives the same numbers, to the bit.
  /// Empty: there is none.
  std::function<std::string(std::size_t index, std::uint64_t seed)> command = {};
  /// The cell whose seed a cell has: cells with the same one are paired. Empty: each has its own.
  std::function<std::size_t(std::size_t index)> seed_cell = {};
};

/// A kind of sweep: a row of the catalogue (app/sweeper/catalogue.cpp).
struct SweepKind {
  std::string key;       // "hands": its name on the command line, in files and results
  std::string question;  // that it answers, one sentence
  std::vector<Option> options;
  /// Reads the files named by the options and makes the cells. Problems: all at once, options.problems() among them.
  Result<Cells> (*make)(Options& options);
};

}  // namespace underact::sweep
