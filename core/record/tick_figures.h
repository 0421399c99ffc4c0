#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/types.h"

namespace underact::record {

/// Error and force over a stretch of ticks. Without a tick they are no numbers.
class TickFigures {
 public:
  /// error_m: between tip and target; force_N: the length of the force that was sent.
  void add(double error_m, double force_N) {
    ++ticks_;
    sum_square_error_m2_ += error_m * error_m;
    sum_force_N_ += force_N;
    peak_force_N_ = std::max(peak_force_N_, force_N);
  }
  std::int64_t ticks() const { return ticks_; }
  double rmsError_m() const { return std::sqrt(sum_square_error_m2_ / static_cast<double>(ticks_)); }
  double meanForce_N() const { return sum_force_N_ / static_cast<double>(ticks_); }
  double peakForce_N() const { return ticks_ == 0 ? kNotANumber : peak_force_N_; }

 private:
  std::int64_t ticks_ = 0;
  double sum_square_error_m2_ = 0.0, sum_force_N_ = 0.0, peak_force_N_ = 0.0;
};

}  // namespace underact::record
