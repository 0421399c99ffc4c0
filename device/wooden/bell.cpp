#include "device/wooden/bell.h"

#include <algorithm>
#include <cerrno>
#include <ctime>

#include "core/base/excepted.h"
#include "core/servo/platform.h"

namespace underact::device {

#ifdef __linux__

// Rings that nobody has heard yet; more than an arm sends while a thread is held up, fewer than take long to drop.
constexpr int kMostHeard = 1000;

Bell::Bell() {
  ::sem_init(&semaphore_, 0, 0);
}

Bell::~Bell() {
  ::sem_destroy(&semaphore_);
}

void Bell::ring() noexcept {
  UNDERACT_EXCEPTED("one atomic add, and a wake where one waits: never waits", ::sem_post(&semaphore_));
}

/// Takes one ring, where there is one.
bool Bell::isHeard() noexcept {
  return UNDERACT_EXCEPTED("one atomic step: never waits", ::sem_trywait(&semaphore_)) == 0;
}

bool Bell::waitFor(std::int64_t time_ns) noexcept {
  if (!isHeard()) {
    const std::int64_t end_ns = servo::monotonicNow_ns() + std::max<std::int64_t>(time_ns, 0);
    const timespec end{static_cast<std::time_t>(end_ns / 1'000'000'000), static_cast<long>(end_ns % 1'000'000'000)};
    int result = 0;
    do {
      result =
          UNDERACT_EXCEPTED("the wait for a sample: until `end`", ::sem_clockwait(&semaphore_, CLOCK_MONOTONIC, &end));
    } while (result != 0 && UNDERACT_EXCEPTED("reads a word of this thread alone", errno) == EINTR);
    if (result != 0) return false;
  }
  for (int ring = 0; ring < kMostHeard && isHeard(); ++ring) {
  }
  return true;
}

#else

constexpr std::int64_t kLook_ns = 200'000;

Bell::Bell() = default;
Bell::~Bell() = default;

void Bell::ring() noexcept {
  rung_.store(true, std::memory_order_release);
}

bool Bell::waitFor(std::int64_t time_ns) noexcept {
  const std::int64_t end_ns = servo::monotonicNow_ns() + time_ns;
  for (;;) {
    if (rung_.exchange(false, std::memory_order_acquire)) return true;
    const std::int64_t now_ns = servo::monotonicNow_ns();
    if (now_ns >= end_ns) return false;
    servo::platform::sleepUntil(std::min(now_ns + kLook_ns, end_ns));
  }
}

#endif

}  // namespace underact::device
