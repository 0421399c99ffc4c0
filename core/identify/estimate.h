#pragma once

namespace underact::identify {

// A quantity below so many standard deviations is not told from zero.
inline constexpr double kTold = 2.0;

/// A quantity with one standard deviation. What is not told from zero is said as "below limit()".
struct Estimate {
  double value = 0.0;
  double uncertainty = 0.0;
  /// Whether it is above zero by more than kTold standard deviations.
  bool isTold() const { return value > kTold * uncertainty; }
  /// What it is below, but for the tail beyond kTold standard deviations; a value below 0 counts as 0.
  double limit() const { return (value > 0.0 ? value : 0.0) + kTold * uncertainty; }
};

}  // namespace underact::identify
