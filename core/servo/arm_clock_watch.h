#pragma once
#include <cstdint>

#include "core/base/fault.h"
#include "core/base/real_time.h"

namespace underact::servo {

/// Holds the clock of an arm's samples against the servo's, over a second at a time. An arm's clock may go by real time
/// (a driver that stamps what comes in), or by its own samples, a period each (a simulated arm, whose ticks may come
/// late), or anywhere between; beyond both by more than a tenth of a second it is no clock. So a rate that is off by a
/// tenth is found within a second, a leap of 0.2 s at once; crystals, which are off by 0.1 per mille at most, and
/// networks, whose samples come some ms too late or too early, never. A sample that is not newer than the one before is
/// the tick's to judge (StaleSample), and counts for nothing here.
class ArmClockWatch {
 public:
  static constexpr std::int64_t kSlack_ns = 100'000'000;
  static constexpr std::int64_t kWindow_ns = 1'000'000'000;

  /// What was before says nothing: a Start, an arm that begins anew, another period.
  void forget() noexcept UNDERACT_REAL_TIME { has_begun_ = false; }

  /// A sample came. sample_ns: by the arm's clock, any number. earliest_ns, latest_ns: between which two moments of the
  /// servo's time it was given, so that a thread that is held up is no fault of the arm's. Gives OddClock where the
  /// two do not go together, and begins anew then.
  Fault look(std::int64_t sample_ns, std::int64_t earliest_ns, std::int64_t latest_ns,
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
