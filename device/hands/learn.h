#pragma once
#include <optional>

#include "device/hands/motion.h"

namespace underact::device::hands {

/// What a person moved to say "this one".
struct Learnt {
  Source source;
  bool inverted = false;  // it went down
};

/// What has moved furthest since `before`, by half its way or more; else the first button that was pressed since. An
/// axis that rested at its end is a trigger; another one that rests so is its counterpart. None: nothing yet.
std::optional<Learnt> learn(const Readings& before, const Readings& now);

/// The first button that was pressed since.
std::optional<int> learnButton(const Readings& before, const Readings& now);

}  // namespace underact::device::hands
