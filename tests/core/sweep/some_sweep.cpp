#include "tests/core/sweep/some_sweep.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

namespace underact::test {
namespace {

std::atomic<int> run{0};

Result<sweep::Cells> make(sweep::Options& options) {
  sweep::Cells cells;
  cells.count = static_cast<std::size_t>(options.integer("cells", 0, 100'000'000));
  const std::int64_t bad = options.integer("bad", -1, 1000), thrown = options.integer("thrown", -1, 1000);
  const std::int64_t few = options.integer("short", -1, 1000), wait_us = options.integer("wait_us", 0, 1'000'000);
  if (!options.problems().empty()) return options.problems();
  cells.columns = {"half", "seed_again", "word"};
  cells.files = {{"a file", options.text("content")}};
  cells.run = [=](std::size_t index, std::uint64_t seed) -> Result<sweep::SweepRow> {
    ++run;
    std::this_thread::sleep_for(std::chrono::microseconds(wait_us));
    const auto number = static_cast<std::int64_t>(index);
    if (number == bad) return Problems{{"It is bad."}};
    if (number == thrown) throw std::runtime_error("it was thrown");
    sweep::SweepRow row;
    row.add(0.5 * static_cast<double>(index));
    row.add(seed);
    if (number != few) row.add(index % 2 == 0 ? "even" : "odd, \"and\" more");
    return row;
  };
  return cells;
}

}  // namespace

SweepFolder::SweepFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "underact-sweep-XXXXXX").string();
  path_ = mkdtemp(name.data());
}

SweepFolder::~SweepFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

SmallFiles::SmallFiles(rlim_t bytes) {
  before_signal_ = std::signal(SIGXFSZ, SIG_IGN);
  getrlimit(RLIMIT_FSIZE, &before_);
  const rlimit wanted{bytes, before_.rlim_max};
  setrlimit(RLIMIT_FSIZE, &wanted);
}

SmallFiles::~SmallFiles() {
  setrlimit(RLIMIT_FSIZE, &before_);
  std::signal(SIGXFSZ, before_signal_);
}

sweep::SweepKind someKind() {
  return {"some",
          "What is half of it?",
          {{"cells", "How many", {"20"}},
           {"bad", "Which", {"-1"}},
           {"thrown", "Which", {"-1"}},
           {"short", "Which", {"-1"}},
           {"wait_us", "How long", {"0"}},
           {"content", "Of the file", {"0123"}}},
          make};
}

sweep::Sweep someSweep(const sweep::Options::Values& given, std::uint64_t seed) {
  return sweep::makeSweep(someKind(), given, seed).value();
}

std::string allRows(const sweep::Sweep& sweep) {
  std::string rows;
  for (std::size_t cell = 0; cell < sweep.cells.count; ++cell) rows += sweep::rowOf(sweep, cell).value() + "\n";
  return rows;
}

int cellsRun() {
  return run.exchange(0);
}

std::string textOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

void writeTo(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

}  // namespace underact::test
