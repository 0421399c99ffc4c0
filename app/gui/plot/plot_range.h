#pragma once
#include <vector>

namespace underact::gui {

/// The end of an axis: a round number above the values shown. It grows at once and shrinks only after the values have
/// been small for a while, so that it does not jitter.
class PlotRange {
 public:
  explicit PlotRange(double min) : min_(min), end_(min) {}
  /// greatest: of the values shown, >= 0; time_s: of the newest.
  double update(double greatest, double time_s);
  double end() const { return end_; }
  void clear() { *this = PlotRange(min_); }

 private:
  double min_;
  double end_;
  double small_since_s_ = -1.0;
};

/// The smallest of 1, 2, 5 x 10^k that is not below value (> 0).
double roundUp(double value);
/// Round steps from `from` to `to`: at most `most` of them.
std::vector<double> ticks(double from, double to, int max);
/// Ticks at multiples of least, or of 2, 4, 8 ... times least.
std::vector<double> multiples(double from, double to, double min, int max);
/// Decimals needed to tell the ticks apart.
int decimalsOf(double step);

}  // namespace underact::gui
