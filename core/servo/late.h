#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/real_time.h"

namespace underact::servo {

/// Why a tick started a whole period late, where it can be known.
enum class LateCause : std::uint8_t {
  Overrun,    // the tick before took longer than a period
  Device,     // most of that time went into waiting for the arm
  PageFault,  // the thread touched memory that was not there
  Preempted,  // another thread had taken the core
  Woken,      // none of these: the kernel, or the host of a virtual machine, woke it late
};
inline constexpr std::size_t kLateCauses = 5;
const char* name(LateCause cause);  // "overrun", "device", "page_fault", "preempted", "woken"

/// How a tick began: what the thread knows and the loop does not.
struct Wake {
  std::int64_t lateness_ns = 0;
  std::int64_t left_out = 0;  // deadlines that had passed by then: they are not caught up
  LateCause cause = LateCause::Woken;
  std::int64_t at_ns = 0;  // by the servo's clock; 0: it has none, and each tick is a period (Clock::Manual)
};

/// The time of the deadlines that passed before a tick that came so late, s: what Wake::left_out says, from numbers
/// that a recording has. None is counted beyond an hour.
double waited_s(std::int64_t lateness_ns, std::int64_t period_ns) noexcept UNDERACT_REAL_TIME;

/// Late ticks since the loop was made, or was given another period.
struct LateTicks {
  std::int64_t total = 0;
  std::array<std::int64_t, kLateCauses> by_cause{};
  std::int64_t left_out = 0;
};

}  // namespace underact::servo
