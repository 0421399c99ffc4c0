#pragma once
#include <cstdint>
#include <ctime>

#include "core/base/real_time.h"

namespace underact::servo {

/// CLOCK_MONOTONIC, ns. Read by the loop around a tick, never in it. Linux answers it without a system call.
inline std::int64_t monotonicNow_ns() noexcept UNDERACT_REAL_TIME {
#if defined(__clang__) && __clang_major__ >= 20
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wfunction-effects"
#endif
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
#if defined(__clang__) && __clang_major__ >= 20
#pragma clang diagnostic pop
#endif
  return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

}  // namespace underact::servo
