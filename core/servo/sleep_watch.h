#pragma once
#include <algorithm>
#include <cstdint>

#include "core/system/clock.h"

namespace underact::servo {

/// Detects that the machine was suspended: the clock that continues during sleep has moved ahead of the other one.
class SleepWatch {
 public:
  /// The shortest sleep that is reported: a machine sleeps for seconds; Windows' clocks agree to within 16 ms.
  static constexpr std::int64_t kShortest_ns = 50'000'000;

  /// Forgets the past: the next look is the first one.
  void reset() noexcept UNDERACT_REAL_TIME { knows_ = false; }

  /// How long it slept since the last look; 0: it was awake. The clock with sleep is read first: a thread that is
  /// delayed between the two readings sees too small a difference, which is never taken for sleep. For the same reason
  /// the first look, the reference for all others, takes the greatest of three.
  std::int64_t poll(const system::Clocks& clocks) noexcept UNDERACT_REAL_TIME {
    return poll(clocks, aheadNow_ns(clocks));
  }

  /// poll() where both were read already, in that order: how far the one with sleep was ahead.
  std::int64_t poll(const system::Clocks& clocks, std::int64_t ahead_ns) noexcept UNDERACT_REAL_TIME {
    if (!knows_) {
      knows_ = true;
      max_ahead_ns_ = std::max({ahead_ns, aheadNow_ns(clocks), aheadNow_ns(clocks)});
      return 0;
    }
    const std::int64_t slept_ns = ahead_ns - max_ahead_ns_;
    max_ahead_ns_ = std::max(max_ahead_ns_, ahead_ns);
    return slept_ns >= kShortest_ns ? slept_ns : 0;
  }

 private:
  static std::int64_t aheadNow_ns(const system::Clocks& clocks) noexcept UNDERACT_REAL_TIME {
    const std::int64_t with_sleep_ns = clocks.with_sleep_ns();
    return with_sleep_ns - clocks.now_ns();
  }

  bool knows_ = false;
  std::int64_t max_ahead_ns_ = 0;
};

}  // namespace underact::servo
