#pragma once
#include <algorithm>
#include <cstdint>

#include "core/system/clock.h"

namespace underact::servo {

/// Whether the machine was suspended: the clock that goes on meanwhile is further ahead of the other one than it was.
class SleepWatch {
 public:
  /// A machine sleeps for seconds; Windows' clocks know of each other to within 16 ms.
  static constexpr std::int64_t kShortest_ns = 50'000'000;

  /// What was before says nothing: the next look is the first one.
  void forget() noexcept UNDERACT_REAL_TIME { knows_ = false; }

  /// How long it slept since the last look; 0: it was awake. The clock with sleep is read first: a thread that is held
  /// up between the two sees them nearer to each other than they are, and never takes that for sleep. For the same
  /// reason the first look, which all others are held against, is three.
  std::int64_t look(const system::Clocks& clocks) noexcept UNDERACT_REAL_TIME {
    return look(clocks, aheadNow_ns(clocks));
  }

  /// The same for who has read both, in that order: how far the one with sleep was ahead.
  std::int64_t look(const system::Clocks& clocks, std::int64_t ahead_ns) noexcept UNDERACT_REAL_TIME {
    if (!knows_) {
      knows_ = true;
      most_ahead_ns_ = std::max({ahead_ns, aheadNow_ns(clocks), aheadNow_ns(clocks)});
      return 0;
    }
    const std::int64_t slept_ns = ahead_ns - most_ahead_ns_;
    most_ahead_ns_ = std::max(most_ahead_ns_, ahead_ns);
    return slept_ns >= kShortest_ns ? slept_ns : 0;
  }

 private:
  static std::int64_t aheadNow_ns(const system::Clocks& clocks) noexcept UNDERACT_REAL_TIME {
    const std::int64_t with_sleep_ns = clocks.with_sleep_ns();
    return with_sleep_ns - clocks.now_ns();
  }

  bool knows_ = false;
  std::int64_t most_ahead_ns_ = 0;
};

}  // namespace underact::servo
