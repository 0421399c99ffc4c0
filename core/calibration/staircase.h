#pragma once
#include <optional>
#include <vector>

namespace underact::calibration {

/// The rule of a staircase. Differences are relative: 0.1 means a tenth more than the reference.
struct StaircaseRule {
  double first = 0.5;      // difference of the first trial
  double min = 0.005;      // never below
  double max = 1.5;        // never above
  double coarse = 2.0;     // factor of each step up to the second reversal
  double fine = 1.4;       // factor from then on
  int right_in_a_row = 2;  // right answers to make it harder; one wrong answer makes it easier
  int reversals = 10;      // it ends after so many reversals
  int max_trials = 100;    // or after so many trials
};

/// An adaptive staircase of a two-alternative forced choice; with two right answers in a row it converges to the
/// difference at which 70.7 % of answers are right. Source: Levitt 1971, "Transformed up-down methods in
/// psychoacoustics".
struct Staircase {
  StaircaseRule rule;
  double difference = 0.0;  // of the next trial
  int right_now = 0;        // right answers since the last step
  int direction = 0;        // -1: the last step was to harder, +1: to easier, 0: none yet
  int trials = 0;
  std::vector<double> reversals;  // the differences at the reversals
};

/// rule: first, least and most above 0 and in order, factors above 1, counts above 0.
Staircase beginStaircase(const StaircaseRule& rule = {});

/// The staircase after one more answer.
Staircase answered(Staircase staircase, bool right);

/// Whether it has as many reversals, or trials, as its rule asks for.
bool isDone(const Staircase& staircase);

/// The just-noticeable difference: the geometric mean of the reversals after the first two, and one standard deviation
/// either way. None before there are four.
struct Threshold {
  double difference = 0.0;
  double low = 0.0;
  double high = 0.0;
};
/// Of an unfinished staircase, too. Mean and deviation are of the logarithms.
std::optional<Threshold> thresholdOf(const Staircase& staircase);

}  // namespace underact::calibration
