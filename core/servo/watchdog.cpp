#include "core/servo/watchdog.h"

#include <chrono>

#include "core/system/clock.h"

namespace underact::servo {

constexpr int kLooksInLimit = 5;  // checks within the limit, so that it is late by a fifth at most

Watchdog::Watchdog(Loop& loop, DevicePort& device, std::int64_t limit_ns)
    : loop_(loop), device_(device), limit_ns_(limit_ns), thread_(&Watchdog::run, this) {}

Watchdog::~Watchdog() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void Watchdog::run() {
  const std::chrono::nanoseconds pause(limit_ns_ / kLooksInLimit);
  std::int64_t seen = loop_.beats(), seen_ns = system::monotonicNow_ns();
  std::unique_lock<std::mutex> lock(mutex_);
  while (!wake_.wait_for(lock, pause, [this] { return ends_; })) {
    const std::int64_t beats = loop_.beats(), now_ns = system::monotonicNow_ns();
    if (beats != seen) {
      seen = beats;
      seen_ns = now_ns;
    } else if (now_ns - seen_ns >= limit_ns_) {
      loop_.reportStall(now_ns - seen_ns);
      device_.cut();
    }
  }
}

}  // namespace underact::servo
