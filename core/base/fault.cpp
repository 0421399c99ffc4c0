#include "core/base/fault.h"

#include "core/base/translate.h"

namespace underact {

Sentence whatHappened(const Fault& fault) {
  const auto seen = [&fault](int decimals) { return shownNumber(fault.seen, decimals); };
  const auto allowed = [&fault](int decimals) { return shownNumber(fault.allowed, decimals); };
  switch (fault.kind) {
    case FaultKind::None:
      return {};
    case FaultKind::NoSample:
      return phrase(TRANSLATE_NOOP("problem", "The arm stopped answering."));
    case FaultKind::StaleSample:
      return phrase(TRANSLATE_NOOP("problem", "The arm sent the same sample twice."));
    case FaultKind::NotFinite:
      return phrase(TRANSLATE_NOOP("problem", "The arm sent a position that is not a number."));
    case FaultKind::TooFast:
      return phrase(TRANSLATE_NOOP("problem", "The arm's position jumped at %1 m/s; a hand reaches at most %2 m/s."),
                    {seen(1), allowed(0)});
    case FaultKind::TooLate:
      return phrase(TRANSLATE_NOOP("problem", "%1 ticks in a row were late by a whole period."), {seen(0)});
    case FaultKind::StoodStill:
      return phrase(TRANSLATE_NOOP("problem", "The servo stalled for %1 s."), {seen(2)});
    case FaultKind::OddClock:
      return phrase(TRANSLATE_NOOP("problem", "The arm's clock advanced by %1 s while %2 s passed."),
                    {seen(2), allowed(2)});
    case FaultKind::Asleep:
      return phrase(TRANSLATE_NOOP("problem", "The computer was asleep for %1 s."), {seen(1)});
    case FaultKind::WindowBusy:
      return phrase(TRANSLATE_NOOP("problem", "The window was too busy to hear Stop for %1 s."), {seen(1)});
  }
  return {};
}

Sentence whatToDo(const Fault& fault) {
  switch (fault.kind) {
    case FaultKind::None:
      return {};
    case FaultKind::NoSample:
    case FaultKind::StaleSample:
    case FaultKind::TooFast:
      return phrase(TRANSLATE_NOOP("problem", "Check the cable, then press Start."));
    case FaultKind::NotFinite:
      return phrase(TRANSLATE_NOOP("problem", "Press Start to try again."));
    case FaultKind::TooLate:
      return phrase(TRANSLATE_NOOP(
          "problem", "Close programs that keep the computer busy or choose a lower rate, then press Start."));
    case FaultKind::StoodStill:
    case FaultKind::Asleep:
    case FaultKind::WindowBusy:
      return phrase(TRANSLATE_NOOP("problem", "Press Start to continue."));
    case FaultKind::OddClock:
      return phrase(TRANSLATE_NOOP("problem", "Restart the servo to reopen the arm, then press Start."));
  }
  return {};
}

Sentence describe(const Fault& fault) {
  if (fault.kind == FaultKind::None) return {};
  return oneAfterAnother({whatHappened(fault), phrase(TRANSLATE_NOOP("problem", "Force is off.")), whatToDo(fault)});
}

const char* name(FaultKind kind) {
  switch (kind) {
    case FaultKind::None:
      return "none";
    case FaultKind::NoSample:
      return "no_sample";
    case FaultKind::StaleSample:
      return "stale_sample";
    case FaultKind::NotFinite:
      return "not_finite";
    case FaultKind::TooFast:
      return "too_fast";
    case FaultKind::TooLate:
      return "too_late";
    case FaultKind::StoodStill:
      return "stood_still";
    case FaultKind::OddClock:
      return "odd_clock";
    case FaultKind::Asleep:
      return "asleep";
    case FaultKind::WindowBusy:
      return "window_busy";
  }
  return "none";
}

}  // namespace underact
