#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "core/error_bounds/catalogue.h"
#include "core/error_bounds/malformed_tick.h"
#include "core/error_bounds/regression_cases.h"
#include "core/scene/load_meshes.h"
#include "core/scene/read.h"
#include "tests/support/property.h"

// What the program promises at the extremes, held to: the worst cases found so far, and draws of one's own.
namespace underact::error_bounds {
namespace {

std::vector<RegressionCase> regressionCases() {
  std::ifstream file(std::string(UNDERACT_TEST_DATA) + "/golden/extremes.csv");
  Result<std::vector<RegressionCase>> kept =
      readRegressionCases(std::string{std::istreambuf_iterator<char>(file), {}}, "tests/golden/extremes.csv");
  EXPECT_TRUE(kept) << "see resources/guide/extremes.md for how it is made";
  return kept ? std::move(kept).value() : std::vector<RegressionCase>{};
}

TEST(KeptCases, KeepTheirPromiseWithTheErrorTheyHad) {
  std::set<std::string> seen;
  for (const RegressionCase& kept : regressionCases()) {
    const Row* const row = findRow(kept.key);
    ASSERT_NE(row, nullptr) << kept.key << " is no row any more: make tests/golden/extremes.csv anew";
    seen.insert(kept.key);
    // An hour of ticks takes seconds, of some rows ten; a part of it is asked below.
    if (row->kind == Kind::Drift && !test::isSoak()) continue;
    const Result<Outcome> again = rerunCase(*row, kept.input);
    ASSERT_TRUE(again) << describe(again.problems()[0]);
    EXPECT_LE(again.value().error_ulp, row->promised_ulp) << kept.key << ": " << wordsOf(*row, kept.input);
    // The same bits are asked and answered on every machine. Where a mend makes it better, the cases are made anew.
    EXPECT_DOUBLE_EQ(again.value().error_ulp, kept.error_ulp) << kept.key << ": " << wordsOf(*row, kept.input);
  }
  for (const Row& row : catalogue()) EXPECT_TRUE(seen.contains(row.key)) << row.key << " has no kept case";
}

TEST(Guide, HasARowForEachRowWithItsPromise) {
  std::ifstream file(UNDERACT_SOURCE "/resources/guide/measured_extremes.md");
  const std::string guide{std::istreambuf_iterator<char>(file), {}};
  for (const Row& row : catalogue()) {
    const std::size_t at = guide.find(std::string("| `") + row.key + "` | ");
    ASSERT_NE(at, std::string::npos) << row.key;
    std::string line = guide.substr(at, guide.find('\n', at) - at);
    std::erase(line, '\\');  // a bar in a cell is written \|
    EXPECT_NE(line.find(std::string("| ") + row.asked + " |"), std::string::npos) << line;
    EXPECT_NE(line.find("| " + textOf(row.promised_ulp) + " " + row.promise + " |"), std::string::npos) << line;
  }
}

TEST(Sweep, EveryRowKeepsItsPromise) {
  const int count = test::dearSweep(300, 20'000);
  for (const Row& row : catalogue()) {
    if (row.kind == Kind::Drift) continue;
    Worst worst;
    // A dear row has few cases of a small count, so seeds make up for it.
    for (std::uint64_t seed = 20071201; seed < 20071201 + 8; ++seed) worst = worse(worst, measure(row, seed, count));
    EXPECT_LE(worst.error_ulp, row.promised_ulp) << row.key << ": " << wordsOf(row, worst.input);
    EXPECT_LT(worst.degenerate, worst.cases) << row.key << " has judged nothing";
  }
}

TEST(Sweep, HoursOfTicksKeepTheirPromise) {
  for (const Row& row : catalogue()) {
    if (row.kind != Kind::Drift) continue;
    for (const RegressionCase& kept : regressionCases()) {
      if (kept.key != row.key) continue;
      std::vector<double> input = kept.input;
      input.at(0) = test::dearSweep(360'000, 14'400'000);  // six minutes, or four hours, at 1 kHz
      const Result<Outcome> outcome = rerunCase(row, input);
      ASSERT_TRUE(outcome) << row.key;
      EXPECT_LE(outcome.value().error_ulp, row.promised_ulp) << row.key << ": " << wordsOf(row, input);
    }
  }
}

TEST(StrangeTick, NoSceneThatShipsIsMovedByWhatNoArmSends) {
  int scenes = 0;
  for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(UNDERACT_SOURCE "/scenes")) {
    if (entry.path().extension() != ".json" || entry.path().stem() == "scene.schema") continue;
    Result<scene::Description> scene = scene::readSceneFile(entry.path().string());
    ASSERT_TRUE(scene) << entry.path();
    const Result<tick::TickProgram> program = scene::loadAndCompile(scene.value());
    ASSERT_TRUE(program) << entry.path() << ": " << describe(program.problems()[0]);
    ++scenes;
    for (std::uint64_t draw = 0; draw < static_cast<std::uint64_t>(test::dearSweep(12, 2000)); ++draw) {
      Input input(caseSeed(20071202, draw));
      const Outcome outcome = checkMalformedTick(program.value(), input);
      ASSERT_LE(outcome.error_ulp, 4.0) << entry.path() << ": " << input.words();
    }
  }
  EXPECT_GE(scenes, 29);
}

TEST(StrangeTick, SeesAStateThatIsNoNumber) {
  tick::TickState state;
  EXPECT_TRUE(isFinite(state));
  state.entries.emplace_back();
  EXPECT_TRUE(isFinite(state));
  state.entries[0].law.velocity.place_W.y() = kNotANumber;
  EXPECT_FALSE(isFinite(state));
  state.entries.clear();
  state.gate.heat.x() = kInfinity;
  EXPECT_FALSE(isFinite(state));
}

}  // namespace
}  // namespace underact::error_bounds
