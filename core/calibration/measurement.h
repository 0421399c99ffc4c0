#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/calibration/trial.h"

namespace underact::calibration {

/// A trial with the answer that it got.
struct Answered {
  Trial trial;
  Beam answer = Beam::Left;
  bool turned = false;  // the way of the staircase turned here

  /// Whether the answer names the stiffer beam.
  bool isRight() const { return answer == trial.stiffer; }
};

/// A whole measurement: the trial that waits for an answer, and those that have one. The same seed and answers give the
/// same trials, whoever answers.
struct Measurement {
  double reference_N_per_mm = 0.0;
  Staircase staircase;
  std::uint64_t sides = 1;  // of the draws of the stiffer side
  Trial trial;
  std::vector<Answered> answers;
};

/// reference_N_per_mm: above 0.
Measurement beginMeasurement(double reference_N_per_mm, std::uint64_t seed);

/// The run after the answer to its trial.
Measurement answered(Measurement run, Beam answer);

/// Whether its staircase has ended; no further trial is drawn then.
bool isDone(const Measurement& run);

/// The standard deviation, as a share, of one press of a hand that has this threshold: it compares two presses, and 2
/// right answers in a row are met at 70.7 % right, so ln(1 + d) = 0.5450 sqrt(2) w.
double scatterOf(double threshold);

/// The run as CSV: a line that begins with # and sums it up, a head, a line a trial. Numbers read back to the same
/// double. answered_by: "a person"; without a comma.
std::string csvOf(const Measurement& run, const std::string& answered_by, std::uint64_t seed);

}  // namespace underact::calibration
