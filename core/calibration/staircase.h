#pragma once
#include <optional>
#include <vector>

namespace underact::calibration {

/// How a staircase climbs. Differences are shares: 0.1 means a tenth more than the reference.
struct StaircaseRule {
  double first = 0.5;      // difference of the first trial
  double least = 0.005;    // never below
  double most = 1.5;       // never above
  double coarse = 2.0;     // each step multiplies or divides by it, up to the second reversal
  double fine = 1.4;       // and from then on by this
  int right_in_a_row = 2;  // so many right answers make it harder; one wrong one makes it easier
  int reversals = 10;      // it ends after so many turns of the way
  int most_trials = 100;   // or after so many trials
};

/// An adaptive staircase of a two-alternative forced choice; with 2 right answers in a row it goes to the difference at
/// which 70.7 % of answers are right. Source: Levitt 1971, "Transformed up-down methods in psychoacoustics".
struct Staircase {
  StaircaseRule rule;
  double difference = 0.0;  // of the trial to come
  int right_now = 0;        // right answers since it last moved
  int way = 0;              // -1: the last move was to harder, +1: to easier, 0: none yet
  int trials = 0;
  std::vector<double> reversals;  // the differences at which the way turned
};

/// rule: first, least and most above 0 and in order, factors above 1, counts above 0.
Staircase beginStaircase(const StaircaseRule& rule = {});

/// The staircase after one more answer.
Staircase answered(Staircase staircase, bool right);

/// Whether it has as many reversals, or trials, as its rule asks for.
bool isDone(const Staircase& staircase);

/// The just-noticeable difference: the geometric mean of the reversals after the first two, and a factor of one
/// standard deviation of them either way. None before there are four.
struct Threshold {
  double difference = 0.0;
  double low = 0.0;
  double high = 0.0;
};
/// Of a staircase that is under way, too. Mean and deviation are of the logarithms.
std::optional<Threshold> thresholdOf(const Staircase& staircase);

}  // namespace underact::calibration
