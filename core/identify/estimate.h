#pragma once

namespace underact::identify {

// A quantity below so many standard deviations is not told from zero.
inline constexpr double kTold = 2.0;

/// A quantity with one standard deviation. One not distinguishable from zero is stated as "below limit()".
struct Estimate {
  double value = 0.0;
  double uncertainty = 0.0;
  bool isTold() const { return value > kTold * uncertainty; }
  double limit() const { return (value > 0.0 ? value : 0.0) + kTold * uncertainty; }
};

}  // namespace underact::identify
