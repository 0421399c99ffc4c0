#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace underact::lab {

/// Times of one piece of work on this machine, ns. No times: 0.
struct Cost {
  double p50_ns = 0.0, p99_ns = 0.0, max_ns = 0.0;
};

/// Times single runs by the steady clock, less the cost of reading it.
class Stopwatch {
 public:
  /// times: how many are to come, so that none allocates. Takes the cost of reading the clock, the least of 1000
  /// readings.
  explicit Stopwatch(std::size_t times);
  /// Runs the work once and keeps how long it took.
  template <class Work>
  void time(const Work& work) {
    const std::int64_t start_ns = now_ns();
    work();
    add(now_ns() - start_ns);
  }
  /// Leaves out the last time. There is one.
  void forgetLast() { times_ns_.pop_back(); }
  /// Median, 99th percentile and maximum of the times kept; all 0 where there are none.
  Cost cost() const;

 private:
  static std::int64_t now_ns();
  void add(std::int64_t took_ns);
  std::int64_t reading_ns_;
  std::vector<double> times_ns_;
};

/// The smallest value that the given share of all values does not exceed; share: above 0, up to 1. 0.5: the median, of
/// an even number the smaller of the two in the middle. values: at least one.
double quantile(std::vector<double> values, double share);

}  // namespace underact::lab
