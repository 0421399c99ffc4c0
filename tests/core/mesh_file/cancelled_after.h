#pragma once
#include <atomic>
#include <chrono>
#include <thread>

#include "core/base/task_monitor.h"

namespace underact::test {

/// A watch that is cancelled after that time, by another thread.
class CancelledAfter {
 public:
  explicit CancelledAfter(std::chrono::milliseconds time)
      : canceller_([this, time] {
          std::this_thread::sleep_for(time);
          since_ = Clock::now();
          cancelled_ = true;
        }) {}
  TaskMonitor monitor() const { return {.progress = {}, .cancelled = &cancelled_}; }
  /// How long ago; waits until it is.
  double secondsSince() {
    const Clock::time_point now = Clock::now();
    canceller_.join();
    return std::chrono::duration<double>(now - since_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::atomic<bool> cancelled_ = false;
  Clock::time_point since_;
  std::jthread canceller_;
};

}  // namespace underact::test
