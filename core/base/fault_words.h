#pragma once
#include <array>

#include "core/base/fault.h"

namespace underact {

/// A sentence with its numbers apart, so that another language can say it: %1 and %2 are their places.
struct FaultSentence {
  struct Number {
    double value = 0.0;
    int decimals = 0;
  };
  const char* pattern = "";  // marked for translators, in the context "fault"
  std::array<Number, 2> numbers{};
};

// What fault.h says in English, for whoever says it in another language. Empty for FaultKind::None.
FaultSentence happenedSentence(const Fault& fault);
const char* toDoSentence(const Fault& fault);

/// What it means for the hand.
extern const char* const kForceIsOff;

}  // namespace underact
