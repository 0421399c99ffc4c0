#include "core/base/fault.h"

#include <array>
#include <charconv>

#include "core/base/fault_words.h"
#include "core/base/translate.h"

namespace underact {
namespace {

/// As many digits as a person reads, the same in every locale.
std::string digits(double value, int decimals) {
  std::array<char, 400> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals);
  return {text.data(), end.ptr};
}

}  // namespace

const char* const kForceIsOff = QT_TRANSLATE_NOOP("fault", "Force is off.");

FaultSentence happenedSentence(const Fault& fault) {
  switch (fault.kind) {
    case FaultKind::None:
      return {};
    case FaultKind::NoSample:
      return {QT_TRANSLATE_NOOP("fault", "The arm stopped answering."), {}};
    case FaultKind::StaleSample:
      return {QT_TRANSLATE_NOOP("fault", "The arm sent the same sample twice."), {}};
    case FaultKind::NotFinite:
      return {QT_TRANSLATE_NOOP("fault", "The arm sent a position that is not a number."), {}};
    case FaultKind::TooFast:
      return {QT_TRANSLATE_NOOP("fault", "The arm's position jumped by %1 m/s, where a hand reaches %2 m/s at most."),
              {{{fault.seen, 1}, {fault.allowed, 0}}}};
    case FaultKind::TooLate:
      return {QT_TRANSLATE_NOOP("fault", "%1 ticks in a row came a whole period late."), {{{fault.seen, 0}}}};
    case FaultKind::StoodStill:
      return {QT_TRANSLATE_NOOP("fault", "The servo stood still for %1 s."), {{{fault.seen, 2}}}};
    case FaultKind::OddClock:
      return {QT_TRANSLATE_NOOP("fault", "The arm's clock advanced by %1 s while %2 s passed."),
              {{{fault.seen, 2}, {fault.allowed, 2}}}};
    case FaultKind::Asleep:
      return {QT_TRANSLATE_NOOP("fault", "The computer was asleep for %1 s."), {{{fault.seen, 1}}}};
  }
  return {};
}

std::string whatHappened(const Fault& fault) {
  const FaultSentence sentence = happenedSentence(fault);
  std::string text = sentence.pattern;
  for (std::size_t index = 0; index < sentence.numbers.size(); ++index) {
    const auto [value, decimals] = sentence.numbers[index];
    const std::size_t place = text.find("%" + std::to_string(index + 1));
    if (place != std::string::npos) text.replace(place, 2, digits(value, decimals));
  }
  return text;
}

const char* toDoSentence(const Fault& fault) {
  switch (fault.kind) {
    case FaultKind::None:
      return "";
    case FaultKind::NoSample:
    case FaultKind::StaleSample:
    case FaultKind::TooFast:
      return QT_TRANSLATE_NOOP("fault", "Check the cable, then press Start.");
    case FaultKind::NotFinite:
      return QT_TRANSLATE_NOOP("fault", "Press Start to try again.");
    case FaultKind::TooLate:
      return QT_TRANSLATE_NOOP("fault", "Close what keeps the machine busy or choose a lower rate, then press Start.");
    case FaultKind::StoodStill:
    case FaultKind::Asleep:
      return QT_TRANSLATE_NOOP("fault", "Press Start to go on.");
    case FaultKind::OddClock:
      return QT_TRANSLATE_NOOP("fault", "Restart the servo, which opens the arm again, then press Start.");
  }
  return "";
}

std::string whatToDo(const Fault& fault) {
  return toDoSentence(fault);
}

std::string describe(const Fault& fault) {
  if (fault.kind == FaultKind::None) return {};
  return whatHappened(fault) + " " + kForceIsOff + " " + toDoSentence(fault);
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
  }
  return "none";
}

}  // namespace underact
