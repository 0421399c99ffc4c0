#pragma once
#include <vector>

#include "core/base/result.h"
#include "device/openhaptics/abi.h"

namespace underact::device::openhaptics {

/// Rates to try. Published: 500, 1000, 2000 Hz on older interfaces, 8000 / n on others.
inline constexpr int kTriedRates_hz[] = {250, 500, 800, 1000, 1600, 2000, 4000, 8000};

/// The library's scheduler: one for all arms of the process. Not in the tick; any thread.
class Scheduler {
 public:
  static Scheduler& theOne();

  /// Schedules a callback, and starts the scheduler for the first one. Problems: why not; then nothing is scheduled.
  Result<Scheduled> join(const Calls& hd, int rate_hz, Callback callback, void* self);
  /// The last one to leave stops the scheduler.
  void leave(const Calls& hd, Scheduled scheduled);
  /// With a single arm: stops the scheduler and restarts it at another rate. Problems: why not.
  Problems setRate(const Calls& hd, int rate_hz);

  int users() const;
  int rate_hz() const;
  /// Those of kTriedRates_hz that the driver accepted; known once an arm has joined.
  std::vector<int> rates() const;
  /// Why it cannot tick at that rate; empty: it can.
  Sentence refuses(int rate_hz) const;

 private:
  Sentence refusesLocked(int rate_hz) const;
  Sentence refusesBeside(int rate_hz) const;  // if there is another arm
  void tryRates(const Calls& hd);

  int users_ = 0;
  int rate_hz_ = 0;
  std::vector<int> rates_;
};

}  // namespace underact::device::openhaptics
