#pragma once
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

#include "core/servo/loop.h"

namespace underact::servo {

/// Watches a loop's ticks from a thread of its own. After limit_ns without a tick it writes zero force to the device,
/// repeatedly while ticks are missing, and reports the length of the pause to the loop.
class Watchdog {
 public:
  /// Starts the thread; the destructor ends it and waits. loop and device outlive it. limit_ns: above 0.
  Watchdog(Loop& loop, DevicePort& device, std::int64_t limit_ns);
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

 private:
  void run();

  Loop& loop_;
  DevicePort& device_;
  std::int64_t limit_ns_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace underact::servo
