#ifdef __APPLE__
#include <mach/mach.h>
#include <mach/mach_time.h>
#include <mach/thread_policy.h>
#include <pthread.h>

#include <string>

#include "core/base/translate.h"
#include "core/system/thread.h"

// Never compiled and never run: written after Apple's reference (Technical Note TN2169).
namespace underact::system {
namespace {

mach_timebase_info_data_t timebase() noexcept {
  static const mach_timebase_info_data_t kBase = [] {
    mach_timebase_info_data_t base{};
    mach_timebase_info(&base);
    return base;
  }();
  return kBase;
}

// 128 bits: on Apple's processors a step is 125/3 ns, and a 64-bit product would overflow after some years.
std::int64_t fromMach_ns(std::uint64_t steps) noexcept {
  const mach_timebase_info_data_t base = timebase();
  return static_cast<std::int64_t>(static_cast<unsigned __int128>(steps) * base.numer / base.denom);
}

std::uint64_t toMach(std::int64_t ns) noexcept {
  const mach_timebase_info_data_t base = timebase();
  return static_cast<std::uint64_t>(static_cast<unsigned __int128>(ns) * base.denom / base.numer);
}

}  // namespace

std::int64_t monotonicNow_ns() noexcept {
  return fromMach_ns(mach_absolute_time());
}

std::int64_t withSleepNow_ns() noexcept {
  return fromMach_ns(mach_continuous_time());
}

void sleepUntil(std::int64_t deadline_ns) noexcept {
  while (monotonicNow_ns() < deadline_ns) mach_wait_until(toMach(deadline_ns));
}

void nameThread(const char* name) noexcept {
  pthread_setname_np(name);
}

bool runOnCore(int /*core*/) noexcept {
  return false;  // macOS lets no thread choose its core
}

Scheduling askForRealTime(const SchedulingRequest& wanted, int rate_hz) {
  Scheduling granted{
      phrase(TRANSLATE_NOOP("problem", "normal")),
      phrase(TRANSLATE_NOOP(
          "problem", "The servo has never been tested on macOS: the latency that it reports is all that is known.")),
      {}};
  granted.also.push_back(wanted.core >= 0
                             ? phrase(TRANSLATE_NOOP("problem", "core %1 refused"), {std::to_string(wanted.core)})
                             : phrase(TRANSLATE_NOOP("problem", "all cores")));
  granted.also.push_back(phrase(TRANSLATE_NOOP("problem", "memory not locked")));
  if (wanted.method != SchedulingMethod::Normal) {
    const std::int64_t period_ns = 1'000'000'000 / rate_hz;
    thread_time_constraint_policy_data_t policy{};
    policy.period = static_cast<std::uint32_t>(toMach(period_ns));
    policy.computation = static_cast<std::uint32_t>(toMach(period_ns / 5));  // a tick takes some 20 us at worst
    policy.constraint = static_cast<std::uint32_t>(toMach(period_ns / 2));
    policy.preemptible = 1;
    const kern_return_t answer =
        thread_policy_set(pthread_mach_thread_np(pthread_self()), THREAD_TIME_CONSTRAINT_POLICY,
                          reinterpret_cast<thread_policy_t>(&policy), THREAD_TIME_CONSTRAINT_POLICY_COUNT);
    if (answer == KERN_SUCCESS) granted.name = phrase(TRANSLATE_NOOP("problem", "time constraint"));
  }
  granted.also.push_back(phrase(TRANSLATE_NOOP("problem", "untested")));
  return granted;
}

Interruptions interruptions() noexcept {
  return {};  // macOS counts them by process only
}

}  // namespace underact::system
#endif
