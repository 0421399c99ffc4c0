#include "device/input/learn.h"

#include <algorithm>
#include <cmath>

namespace underact::device::input {
namespace {

constexpr double kFar = 0.5;        // share of a stick's range: a hand means it
constexpr double kAtItsEnd = -0.9;  // where a trigger rests

std::optional<int> furthest(const Readings& before, const Readings& now) {
  std::optional<int> best;
  double deflection = kFar;
  for (int axis = 0; axis < std::min({before.axes, now.axes, kMaxAxes}); ++axis) {
    const auto index = static_cast<std::size_t>(axis);
    const double moved = std::abs(now.axis[index] - before.axis[index]);
    if (!(moved >= deflection)) continue;  // NaN, too
    deflection = moved;
    best = axis;
  }
  return best;
}

/// The only other axis that rests at its end.
int counterpart(const Readings& before, int trigger) {
  int found = -1;
  for (int axis = 0; axis < std::min(before.axes, kMaxAxes); ++axis) {
    if (axis == trigger || !(before.axis[static_cast<std::size_t>(axis)] < kAtItsEnd)) continue;
    if (found >= 0) return -1;
    found = axis;
  }
  return found;
}

}  // namespace

std::optional<Learnt> learn(const Readings& before, const Readings& now) {
  if (const std::optional<int> axis = furthest(before, now)) {
    const auto index = static_cast<std::size_t>(*axis);
    if (before.axis[index] < kAtItsEnd) return Learnt{{SourceKind::Triggers, *axis, counterpart(before, *axis)}, false};
    return Learnt{{SourceKind::Axis, *axis, -1}, now.axis[index] < before.axis[index]};
  }
  if (const std::optional<int> button = learnButton(before, now))
    return Learnt{{SourceKind::Buttons, *button, -1}, false};
  return {};
}

std::optional<int> learnButton(const Readings& before, const Readings& now) {
  for (int button = 0; button < std::min(now.buttons, kMaxButtons); ++button) {
    if (now.isPressed(button) && !before.isPressed(button)) return button;
  }
  return {};
}

}  // namespace underact::device::input
