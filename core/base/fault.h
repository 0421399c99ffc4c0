#pragma once
#include <cstdint>

#include "core/base/sentence.h"

namespace underact {

/// Why a tick gave zero force.
enum class FaultKind : std::uint8_t {
  None,
  NoSample,     // the arm gave no sample in time; seen: ticks in a row without one
  StaleSample,  // the sample is not newer than the last one; seen: seconds since the last sample
  NotFinite,    // a joint angle, or the force computed from it, is not finite
  TooFast,      // the tip moved faster than any hand; seen: m/s
  TooLate,      // ticks in a row that started a whole period late; seen: how many
  StoodStill,   // no tick for longer than the watchdog allows; seen: seconds
  OddClock,     // the arm's clock and the servo's disagree; seen: seconds by the arm's, allowed: by the servo's
  Asleep,       // the machine was suspended while the servo pushed; seen: seconds
  WindowBusy,   // the window's thread stood still, so that nobody could press Stop there; seen, allowed: seconds
};
inline constexpr int kFaultKinds = 10;

/// A fault as numbers only, so that the tick can make one; describe() makes sentences of it, outside the tick.
struct Fault {
  FaultKind kind = FaultKind::None;
  double seen = 0.0;
  double allowed = 0.0;
};

/// What happened, one sentence. Empty for FaultKind::None.
Sentence whatHappened(const Fault& fault);

/// What to look at and what to press. Empty for FaultKind::None.
Sentence whatToDo(const Fault& fault);

/// What happened, what it means for the hand, what to do. Empty for FaultKind::None.
Sentence describe(const Fault& fault);

/// A word for logs: "none", "no_sample", "stale_sample", "not_finite", "too_fast", "too_late", "stood_still",
/// "odd_clock", "asleep", "window_busy".
const char* name(FaultKind kind);

}  // namespace underact
