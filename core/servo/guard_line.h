#pragma once
#include <atomic>
#include <cstdint>

namespace underact::servo {

// The descriptors of the guard, for both programs.
inline constexpr int kGuardLineFd = 3;    // shared memory: a GuardLine
inline constexpr int kGuardLifeFd = 4;    // a pipe that nobody writes to: it ends when the program does
inline constexpr int kGuardDeviceFd = 5;  // the arm

/// The shared memory of both programs.
struct GuardLine {
  std::atomic<std::int64_t> beats{0};     // up by one each tick
  std::atomic<std::int64_t> looks{0};     // up by one each time the guard checks, so that a hung one is noticed
  std::atomic<std::int64_t> farewell{0};  // not 0: the program ends in order, so nothing is sent
};
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "two processes share it");

}  // namespace underact::servo
