#ifdef _WIN32
#define _WIN32_WINNT 0x0A00  // Windows 10
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>
// After windows.h, which it needs.
#include <avrt.h>
#undef NOMINMAX
#undef WIN32_LEAN_AND_MEAN

#include <algorithm>
#include <string>

#include "core/base/translate.h"
#include "core/system/thread.h"

// Never run: written after Microsoft's reference, compiled by a test where MinGW is installed. Link with avrt.
namespace underact::system {
namespace {

constexpr DWORD kHighResolution = 0x2;  // CREATE_WAITABLE_TIMER_HIGH_RESOLUTION, which older headers do not have

std::int64_t ticksASecond() noexcept {
  static const std::int64_t kTicks = [] {
    LARGE_INTEGER ticks{};
    QueryPerformanceFrequency(&ticks);  // cannot fail since Windows XP
    return static_cast<std::int64_t>(ticks.QuadPart);
  }();
  return kTicks;
}

/// A timer of the calling thread that wakes within some 0.5 ms; null before Windows 10 1803.
class Timer {
 public:
  Timer() : handle_(CreateWaitableTimerExW(nullptr, nullptr, kHighResolution, TIMER_ALL_ACCESS)) {}
  ~Timer() {
    if (handle_ != nullptr) CloseHandle(handle_);
  }
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;
  HANDLE handle() const { return handle_; }

 private:
  HANDLE handle_;
};

}  // namespace

std::int64_t monotonicNow_ns() noexcept {
  LARGE_INTEGER now{};
  QueryPerformanceCounter(&now);
  const std::int64_t ticks = ticksASecond();
  // In two parts: a single product would overflow after some minutes.
  return now.QuadPart / ticks * kSecond_ns + now.QuadPart % ticks * kSecond_ns / ticks;
}

// The counter above continues in some kinds of sleep and not in others; these two clocks show how long it slept.
std::int64_t withSleepNow_ns() noexcept {
  ULONGLONG awake = 0;  // in steps of 100 ns
  QueryUnbiasedInterruptTime(&awake);
  const std::int64_t slept_ns =
      static_cast<std::int64_t>(GetTickCount64()) * 1'000'000 - static_cast<std::int64_t>(awake) * 100;
  return monotonicNow_ns() + slept_ns;
}

void sleepUntil(std::int64_t deadline_ns) noexcept {
  thread_local const Timer timer;
  for (std::int64_t left_ns = deadline_ns - monotonicNow_ns(); left_ns > 0; left_ns = deadline_ns - monotonicNow_ns()) {
    LARGE_INTEGER due{};
    due.QuadPart = -std::max<std::int64_t>(left_ns / 100, 1);  // below 0: from now on, in steps of 100 ns
    if (timer.handle() != nullptr && SetWaitableTimer(timer.handle(), &due, 0, nullptr, nullptr, FALSE) != 0) {
      WaitForSingleObject(timer.handle(), INFINITE);
    } else {
      Sleep(static_cast<DWORD>(left_ns / 1'000'000));  // 0: the rest of this turn goes to others
    }
  }
}

void nameThread(const char* /*name*/) noexcept {
  // SetThreadDescription is missing from some headers, and nothing depends on the name.
}

bool runOnCore(int core) noexcept {
  if (core < 0 || core >= 64) return false;
  return SetThreadAffinityMask(GetCurrentThread(), DWORD_PTR{1} << core) != 0;
}

Scheduling askForRealTime(const SchedulingRequest& wanted, int /*rate_hz*/) {
  Scheduling granted{
      phrase(TRANSLATE_NOOP("problem", "normal")),
      phrase(TRANSLATE_NOOP(
          "problem", "The servo has never been tested on Windows: the latency that it reports is all that is known.")),
      {}};
  if (wanted.core >= 0) {
    const bool runs = runOnCore(wanted.core);
    granted.also.push_back(
        phrase(runs ? TRANSLATE_NOOP("problem", "core %1") : TRANSLATE_NOOP("problem", "core %1 refused"),
               {std::to_string(wanted.core)}));
  } else {
    granted.also.push_back(phrase(TRANSLATE_NOOP("problem", "all cores")));
  }
  granted.also.push_back(phrase(TRANSLATE_NOOP("problem", "memory not locked")));
  if (wanted.method != SchedulingMethod::Normal) {
    DWORD task = 0;
    const HANDLE mmcss = AvSetMmThreadCharacteristicsW(L"Pro Audio", &task);  // given back when the thread ends
    if (mmcss != nullptr) {
      AvSetMmThreadPriority(mmcss, AVRT_PRIORITY_CRITICAL);
      granted.name = "MMCSS Pro Audio";
    } else if (SetThreadPriority(GetCurrentThread(), THREAD_PRIORITY_TIME_CRITICAL) != 0) {
      granted.name = phrase(TRANSLATE_NOOP("problem", "time critical"));
    }
  }
  granted.also.push_back(phrase(TRANSLATE_NOOP("problem", "untested")));
  return granted;
}

Interruptions interruptions() noexcept {
  return {};  // Windows counts page faults by process only
}

}  // namespace underact::system
#endif
