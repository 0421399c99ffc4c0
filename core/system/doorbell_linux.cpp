#ifdef __linux__
#include <poll.h>
#include <sys/eventfd.h>

#include <algorithm>
#include <cerrno>
#include <ctime>

#include "core/base/excepted.h"
#include "core/system/clock.h"
#include "core/system/doorbell.h"

namespace underact::system {

Doorbell::Doorbell() : file_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {}

void Doorbell::ring() noexcept {
  UNDERACT_EXCEPTED("adds to a counter of the kernel, which never blocks", ::eventfd_write(file_.number(), 1));
}

bool Doorbell::clear() noexcept {
  eventfd_t rings = 0;
  return UNDERACT_EXCEPTED("takes a counter of the kernel, never waits", ::eventfd_read(file_.number(), &rings)) == 0;
}

bool Doorbell::waitFor(std::int64_t time_ns) noexcept {
  const std::int64_t end_ns = monotonicNow_ns() + std::max<std::int64_t>(time_ns, 0);
  while (!clear()) {
    const std::int64_t left_ns = end_ns - monotonicNow_ns();
    if (left_ns <= 0) return false;
    pollfd rung{file_.number(), POLLIN, 0};
    const timespec left{static_cast<std::time_t>(left_ns / 1'000'000'000), static_cast<long>(left_ns % 1'000'000'000)};
    UNDERACT_EXCEPTED("the wait for the other thread: until `end_ns`", ::ppoll(&rung, 1, &left, nullptr));
  }
  return true;
}

}  // namespace underact::system
#endif
