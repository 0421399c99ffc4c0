#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/types.h"

namespace underact::record {

/// Statistics of error and force over a range of ticks. Without a tick they are not numbers.
class TickFigures {
 public:
  /// error_m: between tip and target; force_N: magnitude of the force that was sent.
  void add(double error_m, double force_N) {
    ++ticks_;
    sum_square_error_m2_ += error_m * error_m;
    sum_force_N_ += force_N;
    sum_square_force_N2_ += force_N * force_N;
    peak_force_N_ = std::max(peak_force_N_, force_N);
  }
  std::int64_t ticks() const { return ticks_; }
  /// Root of the mean square of the error.
  double rmsError_m() const { return std::sqrt(sum_square_error_m2_ / static_cast<double>(ticks_)); }
  /// The mean of the forces' lengths.
  double meanForce_N() const { return sum_force_N_ / static_cast<double>(ticks_); }
  /// Root of the mean square of the forces' lengths.
  double rmsForce_N() const { return std::sqrt(sum_square_force_N2_ / static_cast<double>(ticks_)); }
  /// The largest force.
  double peakForce_N() const { return ticks_ == 0 ? kNotANumber : peak_force_N_; }

 private:
  std::int64_t ticks_ = 0;
  double sum_square_error_m2_ = 0.0, sum_square_force_N2_ = 0.0, sum_force_N_ = 0.0, peak_force_N_ = 0.0;
};

/// The work of the force on the hand. A displacement of the tip counts with the force that was in effect during it: the
/// one sent a tick before.
class Work {
 public:
  /// A tick: the force that was sent, N, and the tip when it was sampled, m.
  void add(const Vec3& f_T_W, const Vec3& p_WT) {
    if (begun_) all_J_ += f_T_W_.dot(p_WT - p_WT_);
    max_J_ = std::max(max_J_, all_J_);
    begun_ = true;
    f_T_W_ = f_T_W;
    p_WT_ = p_WT;
  }
  /// Since the first tick; positive where the force moved the hand.
  double all_J() const { return all_J_; }
  double max_J() const { return max_J_; }     // the largest so far
  const Vec3& p_WT() const { return p_WT_; }  // of the last tick

 private:
  bool begun_ = false;
  double all_J_ = 0.0, max_J_ = 0.0;
  Vec3 f_T_W_ = Vec3::Zero(), p_WT_ = Vec3::Constant(kNotANumber);
};

/// The energy in the constraints over a range of ticks.
class StoredEnergy {
 public:
  /// energy_J: after a tick.
  void add(double energy_J) {
    last_J_ = energy_J;
    lowest_J_ = std::min(lowest_J_, energy_J);
  }
  double last_J() const { return last_J_; }
  double lowest_J() const { return lowest_J_; }  // so far; 0 before the first tick

 private:
  double last_J_ = 0.0, lowest_J_ = 0.0;
};

}  // namespace underact::record
