#include "tests/error_bounds/row.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/error_bounds/catalogue.h"
#include "tests/error_bounds/regression_cases.h"

namespace underact::error_bounds {
namespace {

Outcome judgeShare(Input& input) {
  const double share = input.number("share", [](Dice& dice) { return dice.share(); });
  return {share, share < 0.5};
}
const Row kShare{"share", Kind::Base, "", "", 1.0, 1, judgeShare};

TEST(Catalogue, HasEachKeyOnceAndAPromiseForEach) {
  std::set<std::string> keys;
  for (const Row& row : catalogue()) {
    EXPECT_TRUE(keys.insert(row.key).second) << row.key;
    EXPECT_GT(row.promised_ulp, 0.0) << row.key;
    EXPECT_GT(row.cost, 0) << row.key;
    EXPECT_EQ(findRow(row.key), &row);
  }
  EXPECT_GE(keys.size(), 50U);
  EXPECT_EQ(findRow("shape_cirle"), nullptr);
}

TEST(Worst, IsTheSameInWhateverOrderCellsAreMerged) {
  std::vector<Worst> cells;
  for (std::uint64_t seed = 0; seed < 6; ++seed) cells.push_back(measure(kShare, seed, 50));
  Worst forward, backward;
  for (const Worst& cell : cells) forward = worse(forward, cell);
  for (auto cell = cells.rbegin(); cell != cells.rend(); ++cell) backward = worse(*cell, backward);
  const Worst paired = worse(worse(cells[3], cells[0]), worse(worse(cells[5], cells[1]), worse(cells[2], cells[4])));
  for (const Worst& other : {backward, paired}) {
    EXPECT_EQ(forward.error_ulp, other.error_ulp);
    EXPECT_EQ(forward.input, other.input);
    EXPECT_EQ(forward.cases, other.cases);
    EXPECT_EQ(forward.degenerate, other.degenerate);
  }
  EXPECT_EQ(forward.cases, 300);
  EXPECT_GT(forward.degenerate, 100);
  EXPECT_LT(forward.degenerate, 200);
  EXPECT_GT(forward.error_ulp, 0.98);
}

TEST(Worst, KeepsTheSmallerInputOfEqualErrors) {
  const Worst a{1.0, {2.0}, 1, 0}, b{1.0, {3.0}, 1, 0};
  EXPECT_EQ(worse(a, b).input, a.input);
  EXPECT_EQ(worse(b, a).input, a.input);
  EXPECT_EQ(worse(Worst{}, Worst{0.0, {3.0}, 1, 0}).input, b.input) << "a case of no error is a case";
}

TEST(Measure, IsTheSameEachTimeAndAnotherForAnotherSeed) {
  const Row& row = *findRow("shape_circle");
  const Worst once = measure(row, 5, 200), again = measure(row, 5, 200), other = measure(row, 6, 200);
  EXPECT_EQ(once.input, again.input);
  EXPECT_EQ(once.error_ulp, again.error_ulp);
  EXPECT_NE(once.input, other.input);
}

TEST(Measure, AnErrorThatIsNoNumberIsTheWorst) {
  const Row nothing{"nothing", Kind::Base, "", "", 1.0, 1, [](Input&) { return Outcome{kNotANumber, false}; }};
  EXPECT_EQ(measure(nothing, 1, 1).error_ulp, kInfinity);
  EXPECT_EQ(rerunCase(nothing, {}).value().error_ulp, kInfinity);
}

TEST(JudgeAgain, TakesTheNumbersAndDrawsNone) {
  EXPECT_EQ(rerunCase(kShare, {0.25}).value().error_ulp, 0.25);
  EXPECT_TRUE(rerunCase(kShare, {0.25}).value().is_degenerate);
  EXPECT_FALSE(rerunCase(kShare, {}));
  EXPECT_FALSE(rerunCase(kShare, {0.25, 0.5}));
  EXPECT_EQ(wordsOf(kShare, {0.25}), "share 0.25");
}

TEST(JudgeAgain, OfEveryRowGivesTheSameErrorAsWhenItWasDrawn) {
  for (const Row& row : catalogue()) {
    if (row.kind == Kind::Drift) continue;  // a minute of them: the kept cases do it
    const Worst worst = measure(row, 77, 1);
    const Result<Outcome> again = rerunCase(row, worst.input);
    ASSERT_TRUE(again) << row.key;
    EXPECT_EQ(again.value().error_ulp, worst.error_ulp) << row.key;
  }
}

TEST(RegressionCase, ReadsBackToTheSameNumbers) {
  const std::vector<RegressionCase> kept{{"a", 0.1, {1.0 / 3.0, -0.0, 5e-324, kInfinity, -1e308}},
                                         {"b", kInfinity, {}}};
  const Result<std::vector<RegressionCase>> read = readRegressionCases(textOf(kept), "kept.csv");
  ASSERT_TRUE(read);
  ASSERT_EQ(read.value().size(), 2U);
  EXPECT_EQ(read.value()[0].key, "a");
  EXPECT_EQ(read.value()[0].error_ulp, 0.1);
  EXPECT_EQ(read.value()[0].input, kept[0].input);
  EXPECT_TRUE(std::signbit(read.value()[0].input[1]));
  EXPECT_EQ(read.value()[1].error_ulp, kInfinity);
  EXPECT_EQ(textOf(read.value()), textOf(kept));
  EXPECT_TRUE(std::isnan(readRegressionCases("a,1,nan\n", "").value()[0].input[0]));
}

TEST(RegressionCase, SaysWhichLinesAreNone) {
  const Result<std::vector<RegressionCase>> read =
      readRegressionCases("key,error_ulp,input\na,x,1\nb,1,2\nc,1,2 3z\n", "kept.csv");
  ASSERT_FALSE(read);
  ASSERT_EQ(read.problems().size(), 2U);
  EXPECT_EQ(read.problems()[0].place.line, 2);
  EXPECT_EQ(read.problems()[1].place.line, 4);
}

}  // namespace
}  // namespace underact::error_bounds
