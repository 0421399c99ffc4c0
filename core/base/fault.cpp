#include "core/base/fault.h"

#include <array>
#include <charconv>

namespace underact {
namespace {

/// As many digits as a person reads, the same in every locale.
std::string digits(double value, int decimals) {
  std::array<char, 400> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals);
  return {text.data(), end.ptr};
}

}  // namespace

std::string whatHappened(const Fault& fault) {
  switch (fault.kind) {
    case FaultKind::None:
      return {};
    case FaultKind::NoSample:
      return "The arm stopped answering.";
    case FaultKind::StaleSample:
      return "The arm sent the same sample twice.";
    case FaultKind::NotFinite:
      return "The arm sent a position that is not a number.";
    case FaultKind::TooFast:
      return "The arm's position jumped by " + digits(fault.seen, 1) + " m/s, where a hand reaches " +
             digits(fault.allowed, 0) + " m/s at most.";
    case FaultKind::TooLate:
      return digits(fault.seen, 0) + " ticks in a row came a whole period late.";
    case FaultKind::StoodStill:
      return "The servo stood still for " + digits(fault.seen, 2) + " s.";
  }
  return {};
}

std::string whatToDo(const Fault& fault) {
  switch (fault.kind) {
    case FaultKind::None:
      return {};
    case FaultKind::NoSample:
    case FaultKind::StaleSample:
    case FaultKind::TooFast:
      return "Check the cable, then press Start.";
    case FaultKind::NotFinite:
      return "Press Start to try again.";
    case FaultKind::TooLate:
      return "Close what keeps the machine busy or choose a lower rate, then press Start.";
    case FaultKind::StoodStill:
      return "Press Start to go on.";
  }
  return {};
}

std::string describe(const Fault& fault) {
  if (fault.kind == FaultKind::None) return {};
  return whatHappened(fault) + " Force is off. " + whatToDo(fault);
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
  }
  return "none";
}

}  // namespace underact
