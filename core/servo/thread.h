#pragma once
#include <atomic>
#include <future>
#include <thread>

#include "core/servo/loop.h"
#include "core/system/scheduling.h"

namespace underact::servo {

/// The servo thread: ticks a loop on absolute deadlines of monotonicNow_ns(), with the best scheduling that the system
/// grants. After a late tick there is no burst: the deadlines that passed are left out.
class Thread {
 public:
  /// rate_hz: 100 to 10000.
  Thread(Loop& loop, int rate_hz, const system::SchedulingWanted& wanted);
  ~Thread();  // zero force, then the thread ends
  Thread(const Thread&) = delete;
  Thread& operator=(const Thread&) = delete;
  const system::Scheduling& scheduling() const { return scheduling_; }

  /// Zero force within a period, and no tick until resume(), which begins with a fresh deadline.
  void rest();
  /// Ticks again. Does not wait.
  void resume();

 private:
  enum class Wish : std::uint8_t { Tick, Rest, End };
  void tell(Wish wish);
  void run(std::promise<system::Scheduling> granted);
  void tickWhileWished();

  Loop& loop_;
  int rate_hz_;
  system::SchedulingWanted wanted_;
  std::atomic<Wish> wish_{Wish::Tick};
  system::Scheduling scheduling_;
  std::thread thread_;
};

}  // namespace underact::servo
