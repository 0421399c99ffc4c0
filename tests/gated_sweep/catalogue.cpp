#include "app/sweeper/catalogue.h"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>
#include <vector>

#include "core/base/random.h"

// In the place of app/sweeper/catalogue.cpp, which the linker leaves in its library.
namespace underact::sweep {
namespace {

/// The file UNDERACT_TEST_GATE holds a number: cells below it run, the others wait until it is larger. Without the
/// variable all run. It is no option, so that it is no part of what the sweep is.
bool isOpen(std::size_t cell) {
  const char* const gate = std::getenv("UNDERACT_TEST_GATE");
  if (gate == nullptr) return true;
  std::size_t open = 0;
  std::ifstream(gate) >> open;
  return cell < open;
}

Result<Cells> make(Options& options) {
  Cells cells;
  cells.count = static_cast<std::size_t>(options.integer("cells", 1, 1'000'000));
  if (!options.problems().empty()) return options.problems();
  cells.columns = {"mean"};
  cells.run = [](std::size_t index, std::uint64_t seed) -> Result<SweepRow> {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);  // of a test that was killed, too
    while (!isOpen(index)) {
      if (std::chrono::steady_clock::now() > end) return Problems{{"The gate does not open."}};
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    constexpr int kDraws = 1000;
    double sum = 0.0;
    for (int draw = 0; draw < kDraws; ++draw) sum += nextShare(seed);
    SweepRow row;
    row.add(sum / kDraws);
    return row;
  };
  return cells;
}

}  // namespace

std::span<const SweepKind> kinds() {
  static const std::vector<SweepKind> kKinds{
      {"gated", "What is the mean of a thousand?", {{"cells", "How many", {"200"}}}, make}};
  return kKinds;
}

const SweepKind* findKind(std::string_view key) {
  return key == kinds().front().key ? &kinds().front() : nullptr;
}

}  // namespace underact::sweep
