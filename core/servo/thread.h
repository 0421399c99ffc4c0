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
  Thread(ServoLoop& loop, int rate_hz, const system::SchedulingRequest& wanted);
  ~Thread();  // zero force, then the thread ends
  Thread(const Thread&) = delete;
  Thread& operator=(const Thread&) = delete;
  const system::Scheduling& scheduling() const { return scheduling_; }

  /// Zero force within a period, and no tick until resume(), which begins with a fresh deadline.
  void rest();
  /// Ticks again. Does not wait.
  void resume();

 private:
  enum class Request : std::uint8_t { Tick, Rest, End };
  void setRequest(Request request);
  void run(std::promise<system::Scheduling> granted);
  void tickWhileRequested();

  ServoLoop& loop_;
  int rate_hz_;
  system::SchedulingRequest wanted_;
  std::atomic<Request> request_{Request::Tick};
  system::Scheduling scheduling_;
  std::thread thread_;
};

}  // namespace underact::servo
