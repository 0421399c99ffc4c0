#pragma once
#include <optional>

#include "device/input/motion.h"

namespace underact::device::input {

/// The axis or button that a person moved to choose it.
struct Learnt {
  Source source;
  bool inverted = false;  // it went down
};

/// The axis that moved furthest since `before`, by half its range or more; otherwise the first button pressed since. An
/// axis that rested at its end is a trigger; another one that rests so is its counterpart. None: nothing yet.
std::optional<Learnt> learn(const Readings& before, const Readings& now);

/// The first button pressed since.
std::optional<int> learnButton(const Readings& before, const Readings& now);

}  // namespace underact::device::input
