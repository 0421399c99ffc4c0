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
  bool turned = false;  // a reversal of the staircase

  /// Whether the answer names the stiffer beam.
  bool isRight() const { return answer == trial.stiffer; }
};

/// A whole measurement: the trial to be answered, and those that were. The same seed and answers give the same trials.
struct Measurement {
  double reference_N_per_mm = 0.0;
  Staircase staircase;
  std::uint64_t sides = 1;  // random state for the stiffer side
  Trial trial;
  std::vector<Answered> answers;
};

/// reference_N_per_mm: above 0.
Measurement beginMeasurement(double reference_N_per_mm, std::uint64_t seed);

/// The measurement after the answer to its trial.
Measurement answered(Measurement run, Beam answer);

/// Whether its staircase has ended; no further trial is drawn then.
bool isDone(const Measurement& run);

/// The standard deviation, as a share, of a single press of a hand with this threshold: two presses are compared, and
/// two right answers in a row are expected at 70.7 % right, so ln(1 + d) = 0.5450 sqrt(2) w.
double scatterOf(double threshold);

/// The measurement as CSV: a summary line that begins with #, a header, a line for each trial. Numbers read back to the
/// same double. answered_by: "a person"; without a comma.
std::string csvOf(const Measurement& run, const std::string& answered_by, std::uint64_t seed);

}  // namespace underact::calibration
