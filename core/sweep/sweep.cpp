#include "core/sweep/sweep.h"

#include <underact/version.h>

#include <exception>
#include <utility>

#include "core/base/random.h"
#include "core/sweep/build.h"

namespace underact::sweep {
namespace {

constexpr std::size_t kMaxCells = 10'000'000;  // their rows fit into the memory of any machine

std::string headerOf(const SweepKind& kind, const Options& options, std::uint64_t seed, const Cells& cells) {
  std::string text = "# underact-sweep: 1\n";
  const auto add = [&text](const std::string& name, const std::string& value) {
    text += "# " + name + ": " + value + "\n";
  };
  add("version", kVersion);
  add("build", buildOf());
  add("kind", kind.key);
  add("question", kind.question);
  add("seed", std::to_string(seed));
  add("options", options.canonical());
  for (const auto& [file, checksum] : cells.files) {
    SweepRow name;  // so that a file name cannot make a second line
    name.add(file);
    add("file", checksum + " " + name.text());
  }
  add("cells", std::to_string(cells.count));
  return text;
}

std::string columnsOf(const Cells& cells) {
  SweepRow row;
  row.add("cell");
  row.add("seed");
  for (const std::string& column : cells.columns) row.add(column);
  return row.text() + "\n";
}

Problems inCell(std::size_t cell, const std::string& sentence) {
  return {{"Cell " + std::to_string(cell) + ": " + sentence}};
}

}  // namespace

Result<Sweep> makeSweep(const SweepKind& kind, const Options::Values& given, std::uint64_t seed) {
  Result<Options> options = Options::from(kind.options, given);
  if (!options) return options.problems();
  Result<Cells> cells = kind.make(options.value());
  if (!cells) return cells.problems();
  if (cells.value().count == 0) return Problems{{"These options give no cell, so there is nothing to run."}};
  if (cells.value().count > kMaxCells)
    return Problems{{"These options make " + std::to_string(cells.value().count) + " cells; a sweep has at most " +
                     std::to_string(kMaxCells) + ". Divide it into several."}};
  Sweep sweep{kind.key, seed, std::move(cells).value(), {}, {}};
  const std::string about = headerOf(kind, options.value(), seed, sweep.cells);
  const std::string columns = columnsOf(sweep.cells);
  sweep.fingerprint = checksumOf(about + columns);
  sweep.header = about + "# fingerprint: " + sweep.fingerprint + "\n" + columns;
  return sweep;
}

std::uint64_t seedOf(std::uint64_t sweep_seed, std::size_t cell) {
  // The sweep's seed is mixed first: with plain sums cell 1 of seed 7 would equal cell 0 of seed 8.
  std::uint64_t state = sweep_seed;
  std::uint64_t mixed = nextBits(state) + cell;
  return nextBits(mixed) >> 11U;
}

std::uint64_t seedOf(const Sweep& sweep, std::size_t cell) {
  return seedOf(sweep.seed, sweep.cells.seed_cell ? sweep.cells.seed_cell(cell) : cell);
}

Result<std::string> rowOf(const Sweep& sweep, std::size_t cell) {
  const std::uint64_t seed = seedOf(sweep, cell);
  try {
    const Result<SweepRow> row = sweep.cells.run(cell, seed);
    if (!row) return inCell(cell, row.problems().front().sentence);
    if (row.value().fields() != sweep.cells.columns.size())
      return inCell(cell, "The number of fields in its row differs from that of the columns; the kind " + sweep.kind +
                              " is at fault; please report it.");
    return std::to_string(cell) + "," + std::to_string(seed) + "," + row.value().text();
  } catch (const std::exception& error) {
    return inCell(cell, std::string("It stopped: ") + error.what() + ".");
  }
}

}  // namespace underact::sweep
