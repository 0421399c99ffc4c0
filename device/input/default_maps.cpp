#include "device/input/default_maps.h"

#include "core/base/translate.h"

namespace underact::device::input {
namespace {

// Across the workspace of 160 mm in a second and a half; half a rotation in two.
constexpr double kTop_m_per_s = 0.12, kTop_rad_per_s = 1.5;
// Sticks return to within a tenth of their range; the cap of a 3D mouse closer.
constexpr double kStickZone = 0.12, kCapZone = 0.06;

AxisMap map(MotionAxis motion, Source source, double dead_zone, bool inverted = false) {
  const bool turns = static_cast<std::size_t>(motion) >= kMoves;
  return {source, inverted, dead_zone, 2.0, turns ? kTop_rad_per_s : kTop_m_per_s};
}

Source axis(int number) {
  return {SourceKind::Axis, number, -1};
}

/// Sets the speed of every direction, including those without an input.
Map nothing(double dead_zone) {
  Map made;
  for (std::size_t motion = 0; motion < kMotionAxes; ++motion)
    made.motions[motion] = map(static_cast<MotionAxis>(motion), {}, dead_zone);
  return made;
}

void set(Map& made, MotionAxis motion, Source source, bool inverted = false) {
  AxisMap& one = made.motions[static_cast<std::size_t>(motion)];
  one.source = source;
  one.inverted = inverted;
}

}  // namespace

// Axes and buttons of a gamepad: GLFW 3.3, input guide, "Gamepad axes" and "Gamepad buttons". Down is positive.
void describeController(DeviceState& seen) {
  seen.axis_names = {
      phrase(TRANSLATE_NOOP("problem", "left stick, right")),  phrase(TRANSLATE_NOOP("problem", "left stick, down")),
      phrase(TRANSLATE_NOOP("problem", "right stick, right")), phrase(TRANSLATE_NOOP("problem", "right stick, down")),
      phrase(TRANSLATE_NOOP("problem", "left trigger")),       phrase(TRANSLATE_NOOP("problem", "right trigger"))};
  seen.button_names = {"A",
                       "B",
                       "X",
                       "Y",
                       phrase(TRANSLATE_NOOP("problem", "left bumper")),
                       phrase(TRANSLATE_NOOP("problem", "right bumper")),
                       "Back",
                       "Start",
                       "Guide",
                       phrase(TRANSLATE_NOOP("problem", "left stick")),
                       phrase(TRANSLATE_NOOP("problem", "right stick")),
                       phrase(TRANSLATE_NOOP("problem", "D-pad up")),
                       phrase(TRANSLATE_NOOP("problem", "D-pad right")),
                       phrase(TRANSLATE_NOOP("problem", "D-pad down")),
                       phrase(TRANSLATE_NOOP("problem", "D-pad left"))};
  const Source triggers{SourceKind::Triggers, 5, 4}, bumpers{SourceKind::Buttons, 4, 5};
  seen.pairs = {triggers, bumpers, {SourceKind::Buttons, 11, 13}, {SourceKind::Buttons, 12, 14}};
  seen.default_value = nothing(kStickZone);
  set(seen.default_value, MotionAxis::Right, axis(0));
  set(seen.default_value, MotionAxis::Near, axis(1));
  set(seen.default_value, MotionAxis::Up, triggers);
  set(seen.default_value, MotionAxis::TurnX, axis(3));
  set(seen.default_value, MotionAxis::TurnY, axis(2));
  set(seen.default_value, MotionAxis::TurnZ, bumpers);
  seen.default_value.presses = {0, 2, 1};  // A, X; B stops
}

void describeJoystick(DeviceState& seen, int hats) {
  seen.default_value = nothing(kStickZone);
  set(seen.default_value, MotionAxis::Right, axis(0));
  set(seen.default_value, MotionAxis::Near, axis(1));
  for (int hat = 0; hat < hats; ++hat) {
    const int up = seen.readings.buttons - 4 * (hats - hat);
    if (up < 0) continue;
    seen.pairs.push_back({SourceKind::Buttons, up, up + 2});
    seen.pairs.push_back({SourceKind::Buttons, up + 1, up + 3});
  }
  if (!seen.pairs.empty()) set(seen.default_value, MotionAxis::Up, seen.pairs.front());
  seen.default_value.presses = {0, 1, 2};
}

// HID: x to the right, y towards the person, z down (facts on devices, 3.3), so W's y is -z and W's z is y; the same
// for rotations.
void describeSpaceMouse(DeviceState& seen, int stop) {
  seen.axis_names = {phrase(TRANSLATE_NOOP("problem", "right")),      phrase(TRANSLATE_NOOP("problem", "towards you")),
                     phrase(TRANSLATE_NOOP("problem", "down")),       phrase(TRANSLATE_NOOP("problem", "tilt back")),
                     phrase(TRANSLATE_NOOP("problem", "tilt right")), phrase(TRANSLATE_NOOP("problem", "twist right"))};
  seen.default_value = nothing(kCapZone);
  set(seen.default_value, MotionAxis::Right, axis(0));
  set(seen.default_value, MotionAxis::Near, axis(1));
  set(seen.default_value, MotionAxis::Up, axis(2), true);
  set(seen.default_value, MotionAxis::TurnX, axis(3));
  set(seen.default_value, MotionAxis::TurnZ, axis(4));
  set(seen.default_value, MotionAxis::TurnY, axis(5), true);
  seen.default_value.presses = {0, 1, stop};
}

}  // namespace underact::device::input
