#include "core/servo/watchdog.h"

#include <chrono>
#include <utility>

#include "core/system/clock.h"

namespace underact::servo {

constexpr int kLooksInLimit = 5;  // checks within the limit, so that it is late by a fifth at most

Watchdog::Watchdog(std::function<std::int64_t()> turns, std::int64_t limit_ns,
                   std::function<void(std::int64_t)> stalled)
    : turns_(std::move(turns)), limit_ns_(limit_ns), stalled_(std::move(stalled)), thread_(&Watchdog::run, this) {}

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
  std::int64_t seen = turns_(), seen_ns = system::monotonicNow_ns();
  std::unique_lock<std::mutex> lock(mutex_);
  while (!wake_.wait_for(lock, pause, [this] { return ends_; })) {
    const std::int64_t turns = turns_(), now_ns = system::monotonicNow_ns();
    if (turns != seen) {
      seen = turns;
      seen_ns = now_ns;
    } else if (now_ns - seen_ns >= limit_ns_) {
      stalled_(now_ns - seen_ns);
    }
  }
}

}  // namespace underact::servo
