#pragma once
#include <atomic>
#include <future>
#include <thread>

#include "core/servo/host.h"
#include "core/servo/loop.h"
#include "core/servo/scheduling.h"

namespace underact::servo {

/// The servo thread: ticks a loop on absolute deadlines of CLOCK_MONOTONIC, with the best scheduling that the system
/// grants. A late tick is not caught up in a burst: the deadlines that passed are left out.
class Thread {
 public:
  Thread(Loop& loop, int rate_hz, const SchedulingWanted& wanted);
  ~Thread();  // zero force, then the thread ends
  Thread(const Thread&) = delete;
  Thread& operator=(const Thread&) = delete;
  const Scheduling& scheduling() const { return scheduling_; }

 private:
  void run(std::promise<Scheduling> granted);

  Loop& loop_;
  std::int64_t period_ns_;
  SchedulingWanted wanted_;
  std::atomic<bool> ends_{false};
  Scheduling scheduling_;
  std::thread thread_;
};

}  // namespace underact::servo
