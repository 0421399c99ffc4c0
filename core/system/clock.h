#pragma once
#include <cstdint>

#include "core/base/real_time.h"

namespace underact::system {

inline constexpr std::int64_t kSecond_ns = 1'000'000'000;

/// A monotonic clock, ns since an arbitrary moment: CLOCK_MONOTONIC on Linux, which needs no system call. Read by the
/// loop around a tick, never in it. Any thread.
std::int64_t monotonicNow_ns() noexcept UNDERACT_REAL_TIME;

/// The time including that in which the machine was suspended, during which the other one stands still on Linux:
/// CLOCK_BOOTTIME there. Any thread.
std::int64_t withSleepNow_ns() noexcept UNDERACT_REAL_TIME;

/// Both clocks, to be replaced by a test, which cannot suspend the machine.
struct Clocks {
  /// Reads a clock, ns.
  using Read = std::int64_t() noexcept UNDERACT_REAL_TIME;
  Read* now_ns = monotonicNow_ns;
  Read* with_sleep_ns = withSleepNow_ns;
};

}  // namespace underact::system
