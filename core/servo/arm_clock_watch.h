#pragma once
#include <cstdint>

#include "core/base/fault.h"
#include "core/base/real_time.h"

namespace underact::servo {

/// Compares the clock of an arm's samples with the servo's, over a second at a time. An arm's clock may follow real
/// time (a driver that stamps what comes in), or its own samples, a period each (a simulated arm, whose ticks may come
/// late), or anything between; outside that range by more than a tenth of a second it is a fault. So a rate that is off
/// by a tenth is found within a second, a jump of 0.2 s at once; crystals, off by at most 0.1 per mille, and networks,
/// whose samples come some ms early or late, never raise it. A sample that is not newer than the last one is left to
/// the tick (StaleSample) and ignored here.
class ArmClockWatch {
 public:
  static constexpr std::int64_t kSlack_ns = 100'000'000;
  static constexpr std::int64_t kWindow_ns = 1'000'000'000;

  /// Forgets the past: at a Start, when an arm begins anew, or with another period.
  void reset() noexcept UNDERACT_REAL_TIME { has_begun_ = false; }

  /// Takes a sample. sample_ns: by the arm's clock, any number. earliest_ns, latest_ns: the bounds of the moment in the
  /// servo's time at which it was taken, so that a delayed servo thread is not blamed on the arm. Gives OddClock where
  /// the clocks disagree, and begins anew then.
  Fault check(std::int64_t sample_ns, std::int64_t earliest_ns, std::int64_t latest_ns,
              std::int64_t period_ns) noexcept UNDERACT_REAL_TIME;

 private:
  void begin(std::int64_t sample_ns, std::int64_t earliest_ns, std::int64_t latest_ns) noexcept UNDERACT_REAL_TIME;

  bool has_begun_ = false;
  std::int64_t last_ns_ = 0;                                  // the newest sample
  std::int64_t begin_earliest_ns_ = 0, begin_latest_ns_ = 0;  // of the window's first sample
  std::int64_t advanced_ns_ = 0;                              // since then by the arm's clock
  std::int64_t counted_ns_ = 0;                               // since then a period for each sample
};

}  // namespace underact::servo
