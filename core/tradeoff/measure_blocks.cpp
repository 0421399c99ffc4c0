#include <algorithm>
#include <filesystem>

#include "core/base/units.h"
#include "core/record/session_writer.h"
#include "core/system/this_process.h"
#include "core/tradeoff/measures.h"

namespace underact::tradeoff {
namespace {

/// A temporary file, removed with the object.
class Scratch {
 public:
  Scratch() : path_(std::filesystem::temp_directory_path() / ("underact-trade-" + system::uniqueWord() + ".h5")) {}
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

/// Times the packing, writing and flushing of blocks.
Result<Figures> figuresOf(const Bench& bench, const Settings& settings) {
  const Scratch scratch;
  record::SessionHeader header;
  header.rate_hz = settings.rate_hz;
  header.block_s = settings.block_s;
  Result<record::SessionWriter> made = record::SessionWriter::create(scratch.path(), header);
  if (!made) return made.problems();
  record::SessionWriter& writer = made.value();
  Problems problems = writer.begin(1, 0, {}, bench.scene);
  const auto rows = static_cast<int>(settings.block_s * settings.rate_hz);
  const auto blocks = std::max(kFewestBlocks, static_cast<int>(bench.seconds / settings.block_s));
  lab::Stopwatch watch(static_cast<std::size_t>(blocks));
  servo::TickRecord record;
  for (int block = 0; block < blocks && problems.empty(); ++block) {
    watch.time([&] {
      for (int row = 0; row < rows && problems.empty(); ++row) {
        record.tick = ++record.time_ns;
        problems = writer.add(record);
      }
      if (problems.empty()) problems = writer.flush();
    });
  }
  writer.abandon();
  if (!problems.empty()) return problems;
  lab::Cost cost = watch.cost();
  cost = {cost.p50_ns / rows, cost.p99_ns / rows, cost.max_ns / rows};
  return Figures{cost, 1e-3 * cost.p50_ns * settings.rate_hz, settings.block_s, settings.block_s};
}

}  // namespace

Measure blocksOn(const Bench& bench, const Settings&) {
  return [bench](const Settings& settings) { return figuresOf(bench, settings); };
}

}  // namespace underact::tradeoff
