#include "device/openhaptics/errors.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/base/translate.h"

namespace underact::device::openhaptics {
namespace {

struct Row {
  std::uint32_t code;
  Severity severity;
  const char* sentence;
};

constexpr const char* kRefused =
    TRANSLATE_NOOP("problem", "The arm's driver refused a query that it should support. Report the arm's model.");
constexpr const char* kLost =
    TRANSLATE_NOOP("problem", "The arm's driver got out of step within a frame. Restart the servo.");

// Codes: section 4 of the facts. Force errors are those that the vendor's own helper calls so, and 0x202, which it
// leaves out.
constexpr std::array kRows{
    Row{0x000, Severity::None, ""},
    Row{0x100, Severity::Question, kRefused},
    Row{0x101, Severity::Question, kRefused},
    Row{0x102, Severity::Question, kRefused},
    Row{0x103, Severity::Question, kRefused},
    Row{0x104, Severity::Stop,
        TRANSLATE_NOOP("problem", "The arm's driver no longer knows the arm. Restart the servo.")},
    Row{0x200, Severity::Force,
        TRANSLATE_NOOP("problem",
                       "The arm's motors are too warm, so its driver cuts the force. Let the arm cool down.")},
    Row{0x201, Severity::Force,
        TRANSLATE_NOOP("problem",
                       "The force exceeded what the arm can give, so its driver cut it. Make the scene softer.")},
    Row{0x202, Severity::Force,
        TRANSLATE_NOOP("problem",
                       "The force rose faster than the arm allows, so its driver cut it. Make the scene softer.")},
    Row{0x203, Severity::Force,
        TRANSLATE_NOOP("problem", "The stylus moved faster than the arm allows, so its driver cut the force.")},
    Row{0x204, Severity::Force,
        TRANSLATE_NOOP("problem",
                       "The arm's driver cut the force. Start again; if that does not help, restart the servo.")},
    Row{0x300, Severity::Stop,
        TRANSLATE_NOOP("problem", "The arm reports a fault of its own. Switch it off and on, then restart the servo.")},
    Row{0x301, Severity::Stop,
        TRANSLATE_NOOP("problem", "The arm is already open, here or in another program. Close that first.")},
    Row{0x302, Severity::Stop,
        TRANSLATE_NOOP("problem", "The arm does not answer. Check its cable and its power, then restart the servo.")},
    Row{0x303, Severity::Stop,
        TRANSLATE_NOOP("problem",
                       "The arm cannot be reached with its driver's present settings. Run the vendor's setup, then "
                       "restart the servo.")},
    Row{0x304, Severity::Stop,
        TRANSLATE_NOOP("problem", "The scheduler of the arm's driver failed. Restart the servo.")},
    Row{0x400, Severity::Stop, kLost},
    Row{0x401, Severity::Stop, kLost},
    Row{0x402, Severity::Stop,
        TRANSLATE_NOOP("problem", "The arm's driver could not finish a frame. Restart the servo.")},
    Row{0x500, Severity::Stop,
        TRANSLATE_NOOP("problem", "The arm's driver refused access to its scheduler. Restart the servo.")},
    Row{0x501, Severity::Stop,
        TRANSLATE_NOOP(
            "problem",
            "The scheduler of the arm's driver is full. Close other programs that use it, then restart the servo.")},
    Row{0x600, Severity::Stop,
        TRANSLATE_NOOP("problem", "The arm's driver has no valid licence. Run the vendor's setup.")},
    Row{kEndlessErrors, Severity::Stop,
        TRANSLATE_NOOP("problem", "The arm's driver keeps reporting errors. Quit the program and start it again.")},
    Row{kNotANumberSent, Severity::Question,
        TRANSLATE_NOOP("problem", "The arm sends angles that are not numbers. Restart the servo.")},
};

const Row* find(std::uint32_t code) noexcept {
  const auto* const row = std::find_if(kRows.begin(), kRows.end(), [code](const Row& one) { return one.code == code; });
  return row == kRows.end() ? nullptr : row;
}

constexpr int kMaxErrors = 64;  // more than any frame has calls

}  // namespace

Severity severityOf(std::uint32_t code) noexcept {
  const Row* const row = find(code);
  return row != nullptr ? row->severity : Severity::Stop;
}

Drained drain(const Calls& hd) noexcept {
  Drained drained;
  while (drained.count < kMaxErrors) {
    const std::uint32_t code = hd.hdGetError().code;
    if (code == 0) return drained;
    ++drained.count;
    const Severity severity = severityOf(code);
    if (severity > drained.worst) {
      drained.worst = severity;
      drained.code = code;
    }
  }
  return {Severity::Stop, kEndlessErrors, drained.count};
}

Sentence sentenceOf(std::uint32_t code) {
  if (const Row* const row = find(code)) return phrase(row->sentence);
  std::array<char, 16> number{};
  std::snprintf(number.data(), number.size(), "0x%X", static_cast<unsigned>(code));
  return phrase(TRANSLATE_NOOP("problem", "The arm's driver reports the unknown error %1. Restart the servo."),
                {number.data()});
}

}  // namespace underact::device::openhaptics
