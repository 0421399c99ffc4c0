#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/real_time.h"

namespace underact::servo {

/// Why a tick started a whole period late, where that is known.
enum class LateCause : std::uint8_t {
  Overrun,    // the tick before took longer than a period
  Device,     // most of that time went into waiting for the arm
  PageFault,  // the thread touched memory that was not mapped
  Preempted,  // another thread had taken the core
  Woken,      // none of these: the kernel, or the host of a virtual machine, woke it late
};
inline constexpr std::size_t kLateCauses = 5;
const char* name(LateCause cause);  // "overrun", "device", "page_fault", "preempted", "woken"

/// What the thread knows of the beginning of a tick.
struct Wake {
  std::int64_t lateness_ns = 0;
  std::int64_t left_out = 0;  // deadlines that had passed by then: they are not caught up
  LateCause cause = LateCause::Woken;
  std::int64_t at_ns = 0;  // by the servo's clock; 0: none, each tick is a period (Clock::Manual)
};

/// The time of the deadlines that passed before a tick of that latency, s: that of Wake::left_out, from numbers that a
/// recording has. At most an hour.
double waited_s(std::int64_t lateness_ns, std::int64_t period_ns) noexcept UNDERACT_REAL_TIME;

/// Late ticks since the loop was made, or was given another period.
struct LateTicks {
  std::int64_t total = 0;
  std::array<std::int64_t, kLateCauses> by_cause{};
  std::int64_t left_out = 0;
};

}  // namespace underact::servo
