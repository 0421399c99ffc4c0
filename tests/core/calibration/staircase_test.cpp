#include "core/calibration/staircase.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/random.h"

namespace underact::calibration {
namespace {

/// Answers as told, one letter each: r right, w wrong.
Staircase told(const char* answers, const StaircaseRule& rule = {}) {
  Staircase staircase = beginStaircase(rule);
  for (const char* answer = answers; *answer != '\0'; ++answer) {
    staircase = answered(std::move(staircase), *answer == 'r');
  }
  return staircase;
}

/// Box and Muller.
double gaussian(test::Random& random) {
  return std::sqrt(-2.0 * std::log(random.between(1e-300, 1.0))) * std::cos(random.between(0.0, 6.283185307179586));
}

}  // namespace

TEST(Staircase, TwoRightAnswersMakeItHarderAndOneWrongOneEasier) {
  EXPECT_EQ(told("").difference, 0.5);
  EXPECT_EQ(told("r").difference, 0.5);
  EXPECT_EQ(told("rr").difference, 0.25);
  EXPECT_EQ(told("rrr").difference, 0.25);
  EXPECT_EQ(told("rrrw").difference, 0.5);  // the right one before it does not count
  EXPECT_EQ(told("rrrwr").difference, 0.5);
  EXPECT_EQ(told("rrrwrr").difference, 0.5 / 1.4);  // the second reversal: steps are fine from here on
}

TEST(Staircase, ReversalsAreWhereTheWayTurns) {
  EXPECT_TRUE(told("rrrr").reversals.empty());
  EXPECT_EQ(told("rrrrw").reversals, std::vector<double>{0.125});
  EXPECT_EQ(told("rrrrwrr").reversals, (std::vector<double>{0.125, 0.25}));
  EXPECT_EQ(told("rrrrww").reversals.size(), 1u);
}

TEST(Staircase, StaysWithinItsBoundsAndEnds) {
  StaircaseRule rule;
  rule.max_trials = 30;
  const Staircase always_right = told("rrrrrrrrrrrrrrrrrrrrrrrrrrrrrr", rule);
  EXPECT_EQ(always_right.difference, rule.min);
  EXPECT_TRUE(isDone(always_right));
  EXPECT_FALSE(thresholdOf(always_right));  // it never met what cannot be told
  const Staircase always_wrong = told("wwwwwwwwww", rule);
  EXPECT_EQ(always_wrong.difference, rule.max);
  EXPECT_FALSE(isDone(always_wrong));
  EXPECT_TRUE(isDone(told("rrwrrwrrwrrwrrwrr")));  // ten reversals
}

TEST(Staircase, TheThresholdIsTheGeometricMeanAfterTheRunIn) {
  Staircase staircase = beginStaircase();
  staircase.reversals = {9.0, 9.0, 0.1};
  EXPECT_FALSE(thresholdOf(staircase));
  staircase.reversals = {9.0, 9.0, 0.1, 0.4};
  const Threshold threshold = thresholdOf(staircase).value();
  EXPECT_NEAR(threshold.difference, 0.2, 1e-15);
  EXPECT_NEAR(threshold.low * threshold.high, 0.04, 1e-15);
  EXPECT_NEAR(std::log(threshold.high / threshold.difference), std::log(2.0) * std::sqrt(2.0), 1e-12);
}

// A judge whose feeling of ln(1 + d) scatters by s is right in 70.71 % (sqrt(1/2)) of trials at ln(1 + d) = 0.5450 s.
// The mean over many staircases lies within some 10 % of it: this rule's own bias, from its steps and its start.
TEST(Staircase, ConvergesWhere707PercentAreRight) {
  test::Random random(test::Seed{20070501});
  for (const double scatter : {0.1, 0.2, 0.4}) {
    double sum = 0.0, squares = 0.0;
    constexpr int kRuns = 2000;
    for (int run = 0; run < kRuns; ++run) {
      Staircase staircase = beginStaircase();
      while (!isDone(staircase)) {
        const bool right = std::log1p(staircase.difference) + scatter * gaussian(random) > 0.0;
        staircase = answered(std::move(staircase), right);
      }
      const auto threshold = thresholdOf(staircase);
      ASSERT_TRUE(threshold);
      sum += std::log(threshold->difference);
      squares += std::pow(std::log(threshold->difference), 2);
    }
    const double wanted = std::expm1(0.5450 * scatter);
    EXPECT_NEAR(std::exp(sum / kRuns) / wanted, 1.0, 0.15) << scatter;
    const double mean = sum / kRuns, factor = std::exp(std::sqrt(squares / kRuns - mean * mean));
    EXPECT_GT(factor, 1.55 - 0.03) << "the guide says 1.55 to 1.8";  // of 2000 runs: 1.6 % of the deviation, 0.01
    EXPECT_LT(factor, 1.8 + 0.03);
  }
}

}  // namespace underact::calibration
