#pragma once

namespace underact::identify {

// A quantity below this many standard deviations is not distinguished from zero.
inline constexpr double kTold = 2.0;

/// A quantity with one standard deviation. One that is not distinguished from zero is shown as "below limit()".
struct Estimate {
  double value = 0.0;
  double uncertainty = 0.0;
  /// Whether it is above zero by more than kTold standard deviations.
  bool isSignificant() const { return value > kTold * uncertainty; }
  /// The upper bound, kTold standard deviations above the value; a value below 0 counts as 0.
  double limit() const { return (value > 0.0 ? value : 0.0) + kTold * uncertainty; }
};

}  // namespace underact::identify
