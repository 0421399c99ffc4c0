#pragma once
#include <cstdint>

#include "core/base/sentence.h"
#include "device/openhaptics/abi.h"

namespace underact::device::openhaptics {

/// The consequence of an error of the library. Question: a queried value is missing. Force: the force goes to zero, and
/// the arm continues. Stop: it does not. In this order, the worst last.
enum class Severity : std::uint8_t { None, Question, Force, Stop };

// Beyond the library's own codes.
inline constexpr std::uint32_t kEndlessErrors = 0x10001;  // its stack of errors has no end
inline constexpr std::uint32_t kNotANumberSent = 0x10002;

/// An unknown code is a Stop.
Severity severityOf(std::uint32_t code) noexcept;

/// The content of the error stack.
struct Drained {
  Severity worst = Severity::None;
  std::uint32_t code = 0;  // the first of the worst
  int count = 0;
};

/// Empties the stack; an endless one is a Stop. The thread that made the calls.
Drained drain(const Calls& hd) noexcept;

/// What happened and what to do, for a person.
Sentence sentenceOf(std::uint32_t code);

}  // namespace underact::device::openhaptics
