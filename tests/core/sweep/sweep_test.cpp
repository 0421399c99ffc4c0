#include "core/sweep/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/sweep/build.h"
#include "tests/core/sweep/some_sweep.h"

namespace underact::sweep {
namespace {

using test::someKind;
using test::someSweep;

TEST(CellSeeds, AreAllDifferentAndFitInADouble) {
  std::set<std::uint64_t> seeds;
  for (const std::uint64_t sweep_seed : {0U, 1U, 2U}) {
    for (std::size_t cell = 0; cell < 10'000; ++cell) seeds.insert(seedOf(sweep_seed, cell));
  }
  EXPECT_EQ(seeds.size(), 30'000U) << "also those of neighbouring sweeps";
  EXPECT_LT(*seeds.rbegin(), std::uint64_t{1} << 53U);
}

TEST(CellSeeds, HaveEveryBitInHalfOfThem) {
  constexpr int kCells = 4096;
  for (int bit = 0; bit < 53; ++bit) {
    int count = 0;
    for (std::size_t cell = 0; cell < kCells; ++cell) count += static_cast<int>((seedOf(5, cell) >> bit) & 1U);
    EXPECT_NEAR(count, kCells / 2, 5 * 32) << "5 sigma of a fair coin, bit " << bit;  // sigma = sqrt(4096) / 2
  }
}

TEST(CellSeeds, AreTheSameForever) {  // a result that cannot be made again is none
  EXPECT_EQ(seedOf(1, 0), 3316356330981164U);
  EXPECT_EQ(seedOf(1, 1), 4744253937173237U);
}

TEST(Fingerprint, ChangesWithAllThatTheResultDependsOn) {
  SweepKind other_key = someKind(), other_option = someKind();
  other_key.key = "other";
  other_option.options.push_back({"more", "More", {"1"}});
  const std::set<std::string> fingerprints{
      someSweep().fingerprint,
      someSweep({}, 2).fingerprint,
      someSweep({{"cells", {"21"}}}).fingerprint,
      someSweep({{"content", {"0124"}}}).fingerprint,
      makeSweep(other_key, {}, 1).value().fingerprint,
      makeSweep(other_option, {}, 1).value().fingerprint,
  };
  EXPECT_EQ(fingerprints.size(), 6U);
  EXPECT_EQ(someSweep().fingerprint, someSweep({{"cells", {"20"}}}).fingerprint);
}

TEST(Header, SaysWhatWasRun) {
  const std::string header = someSweep({}, 7).header;
  EXPECT_NE(header.find("# build: " + buildOf() + "\n"), std::string::npos) << header;
  for (const char* line : {"# kind: some\n", "# seed: 7\n", "# file: 0123 a file\n", "# cells: 20\n",
                           "\ncell,seed,half,seed_again,word\n", "\"cells\": [\"20\"]"}) {
    EXPECT_NE(header.find(line), std::string::npos) << line << " in\n" << header;
  }
}

TEST(RowOf, ACellIsItsNumberItsSeedAndItsFields) {
  const Sweep sweep = someSweep({}, 1);
  EXPECT_EQ(rowOf(sweep, 1).value(), "1,4744253937173237,0.5,4744253937173237,\"odd, \"\"and\"\" more\"");
}

TEST(RowOf, TellsWhichCellFailedAndWhy) {
  const Sweep sweep = someSweep({{"bad", {"3"}}, {"thrown", {"4"}}, {"short", {"5"}}});
  EXPECT_EQ(rowOf(sweep, 3).problems().front().sentence, "Cell 3: It is bad.");
  EXPECT_EQ(rowOf(sweep, 4).problems().front().sentence, "Cell 4: It stopped: it was thrown.");
  EXPECT_NE(rowOf(sweep, 5).problems().front().sentence.find("number of fields"), std::string::npos);
}

TEST(MakeSweep, RefusesNoCellsAndTooMany) {
  EXPECT_FALSE(makeSweep(someKind(), {{"cells", {"0"}}}, 1));
  EXPECT_FALSE(makeSweep(someKind(), {{"cells", {"10000001"}}}, 1));
  EXPECT_FALSE(makeSweep(someKind(), {{"cells", {"many"}}}, 1));
  EXPECT_TRUE(makeSweep(someKind(), {{"cells", {"10000000"}}}, 1));
}

TEST(Checksum, TellsContentsApart) {
  EXPECT_EQ(checksumOf("a").size(), 32U);
  EXPECT_NE(checksumOf("a"), checksumOf("b"));
  EXPECT_EQ(checksumOf("a"), checksumOf("a"));
}

}  // namespace
}  // namespace underact::sweep
