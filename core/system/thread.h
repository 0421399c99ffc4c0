#pragma once
#include <cstdint>

#include "core/system/clock.h"
#include "core/system/scheduling.h"

// What the servo needs of the operating system, in thread_linux.cpp, thread_windows.cpp and thread_macos.cpp (with
// monotonicNow_ns() of clock.h). Only Linux is tested.
namespace underact::system {

/// Returns once monotonicNow_ns() has reached deadline_ns; at once where it has passed.
void sleepUntil(std::int64_t deadline_ns) noexcept;

/// The calling thread's name, for debuggers and system monitors; at most 15 characters.
void nameThread(const char* name) noexcept;

/// Runs the calling thread on one core alone. false: refused, or there is no such core.
bool runOnCore(int core) noexcept;

/// Requests the scheduling for the calling thread, which is to tick rate_hz times a second, and touches its stack.
/// Gives what the system granted. May wait some 3 s for another process to answer (rtkit).
Scheduling askForRealTime(const SchedulingRequest& wanted, int rate_hz);

/// Interruptions of the calling thread since it began; 0 where a system does not count by thread.
struct Interruptions {
  std::int64_t page_faults = 0;
  std::int64_t preemptions = 0;  // the core was taken away from it
};
/// Of the calling thread, by a system call. Counted on Linux alone.
Interruptions interruptions() noexcept;

}  // namespace underact::system
