#pragma once
#include <cstdint>
#include <optional>
#include <string>

namespace underact::servo {
struct GuardLine;
}

namespace underact::guard {

/// What the guard is started with: how long ticks may be missing, and the bytes that mean zero force to the arm.
struct Duty {
  std::int64_t limit_ns = 0;
  std::string word;
};

/// From its two arguments: nanoseconds, and the word in hexadecimal digits. Empty where they are neither.
std::optional<Duty> readDuty(int argc, const char* const* argv);

/// Watches until the program ends: 0 where that was orderly, 1 where the arm had to be told, 2 where it could not be
/// watched. See core/servo/guard_line.h for what it is given, and where.
int watch(const Duty& duty);
/// Watches over what is given here: memory that both see, the end of a pipe, the arm.
int watch(const Duty& duty, servo::GuardLine& line, int life_fd, int device_fd);

}  // namespace underact::guard
