#pragma once
#include <array>

#include "core/servo/histogram.h"
#include "core/servo/snapshot.h"

namespace underact::servo {

/// Latency and duration of every tick since the start, and latency of the last 10 s, in steps of a second. One thread;
/// 100 KB.
class Timing {
 public:
  /// rate_hz: of the ticks, above 0.
  explicit Timing(int rate_hz) : ticks_a_second_(rate_hz) {}
  /// The next tick.
  void add(const TickRecord& record) noexcept;
  Percentiles lateness() const noexcept { return lateness_.percentiles(); }
  /// Latency of the last 10 s, counted by ticks at rate_hz.
  Percentiles lateLately() const noexcept;
  Percentiles tickTime() const noexcept { return tick_time_.percentiles(); }
  const Histogram& latenessHistogram() const noexcept { return lateness_; }

 private:
  static constexpr std::size_t kSeconds = 10;
  int ticks_a_second_;
  Histogram lateness_, tick_time_;
  std::array<Histogram, kSeconds>
      lately_;  // the one in use is filled up to a second's ticks, then the oldest is reused
  std::size_t in_use_ = 0;
};

}  // namespace underact::servo
