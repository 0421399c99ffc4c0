#pragma once
#include <cstdint>

#include "core/base/real_time.h"

namespace underact::servo {

/// A clock that no one sets, ns since some moment: CLOCK_MONOTONIC on Linux, which answers without a system call. Read
/// by the loop around a tick, never in it. Any thread.
std::int64_t monotonicNow_ns() noexcept UNDERACT_REAL_TIME;

}  // namespace underact::servo
