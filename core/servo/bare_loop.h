#pragma once
#include <atomic>
#include <semaphore>
#include <thread>

#include "core/servo/histogram.h"
#include "core/system/scheduling.h"

namespace underact::servo {

/// A thread that wakes on deadlines as the servo thread does, measures its latency and does nothing else: the best that
/// this machine can do. It shares only the operating system calls with the servo thread. Idle until resume().
class BareLoop {
 public:
  /// rate_hz: 100 to 10000. Returns when the thread has its scheduling.
  BareLoop(int rate_hz, const system::SchedulingRequest& wanted);
  ~BareLoop();
  BareLoop(const BareLoop&) = delete;
  BareLoop& operator=(const BareLoop&) = delete;
  /// Begins to wake, with a fresh deadline. Does not wait.
  void resume();
  /// No further wake until resume(). Does not wait: one that is due may still come.
  void rest();
  /// Ends the thread; gives the latency of each wake.
  const Histogram& end();

 private:
  enum class Request : std::uint8_t { Rest, Wake, End };
  void setRequest(Request request);
  void run(int rate_hz, const system::SchedulingRequest& wanted, std::binary_semaphore& ready);
  void wakeWhileRequested(std::int64_t period_ns);

  std::atomic<Request> request_{Request::Rest};
  Histogram lateness_;
  std::thread thread_;
};

}  // namespace underact::servo
