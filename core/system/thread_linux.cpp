#ifdef __linux__
#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>

#include <ctime>

#include "core/base/excepted.h"
#include "core/system/thread.h"

namespace underact::system {

namespace {

std::int64_t read_ns(clockid_t clock) noexcept UNDERACT_REAL_TIME {
  timespec now{};
  UNDERACT_EXCEPTED("reads a page the kernel shares: no lock, no heap", clock_gettime(clock, &now));
  return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

}  // namespace

std::int64_t monotonicNow_ns() noexcept {
  return read_ns(CLOCK_MONOTONIC);
}

std::int64_t withSleepNow_ns() noexcept {
  return read_ns(CLOCK_BOOTTIME);
}

void sleepUntil(std::int64_t deadline_ns) noexcept {
  const timespec at{static_cast<time_t>(deadline_ns / 1'000'000'000), static_cast<long>(deadline_ns % 1'000'000'000)};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, nullptr) != 0) {  // a signal came
  }
}

void nameThread(const char* name) noexcept {
  pthread_setname_np(pthread_self(), name);
}

bool runOnCore(int core) noexcept {
  if (core < 0 || core >= CPU_SETSIZE) return false;
  cpu_set_t cores;
  CPU_ZERO(&cores);
  CPU_SET(static_cast<std::size_t>(core), &cores);
  return pthread_setaffinity_np(pthread_self(), sizeof cores, &cores) == 0;
}

Interruptions interruptions() noexcept {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return {usage.ru_minflt + usage.ru_majflt, usage.ru_nivcsw};
}

}  // namespace underact::system
#endif
