#include "core/servo/thread.h"

#include <pthread.h>
#include <sched.h>
#include <sys/prctl.h>

#include <algorithm>
#include <array>
#include <string>

#include "core/servo/clock.h"

namespace underact::servo {
namespace {

constexpr int kPriority = 80;  // above what a desktop runs, below the kernel's own threads (99)

/// For the calling thread: FIFO where the system grants it, and timers that are not put off to save power.
Scheduling askForRealTime() {
  sched_param wanted{};
  wanted.sched_priority = kPriority;
  if (pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted) == 0)
    return {"FIFO " + std::to_string(kPriority), "", {}};
  prctl(PR_SET_TIMERSLACK, 1UL);  // ns; the default of 50 us would be added to every wait
  return {"normal",
          "The system did not grant real-time scheduling, so ticks can come late when the machine is busy. To grant "
          "it, add "
          "\"@users - rtprio 90\" to a file in /etc/security/limits.d and log in again.",
          {}};
}

void touchStack() noexcept {
  std::array<volatile char, 64 * 1024> stack;
  for (std::size_t at = 0; at < stack.size(); at += 1024) stack[at] = 0;
}

void sleepUntil(std::int64_t deadline_ns) noexcept {
  const timespec at{static_cast<time_t>(deadline_ns / 1'000'000'000), static_cast<long>(deadline_ns % 1'000'000'000)};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, nullptr) != 0) {
  }
}

}  // namespace

Thread::Thread(Loop& loop, int rate_hz, const SchedulingWanted& wanted)
    : loop_(loop), period_ns_(1'000'000'000 / rate_hz), wanted_(wanted) {
  std::promise<Scheduling> granted;
  std::future<Scheduling> scheduling = granted.get_future();
  thread_ = std::thread(&Thread::run, this, std::move(granted));
  scheduling_ = scheduling.get();
}

Thread::~Thread() {
  ends_ = true;
  thread_.join();
}

void Thread::run(std::promise<Scheduling> granted) {
  pthread_setname_np(pthread_self(), "underact-servo");
  granted.set_value(askForRealTime());
  touchStack();
  std::int64_t deadline_ns = monotonicNow_ns() + period_ns_;
  while (!ends_.load(std::memory_order_relaxed)) {
    sleepUntil(deadline_ns);
    const std::int64_t now_ns = monotonicNow_ns();
    const std::int64_t late_ns = now_ns - deadline_ns;
    const std::int64_t left_out = late_ns > period_ns_ ? late_ns / period_ns_ : 0;
    loop_.tick({late_ns, left_out, LateCause::Woken});
    deadline_ns += (1 + left_out) * period_ns_;
  }
  loop_.release();
}

}  // namespace underact::servo
