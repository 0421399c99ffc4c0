#pragma once
#include "device/input/device_enumerator.h"

namespace underact::device::input {

/// A controller with the buttons and sticks of a gamepad, in GLFW's order: default mapping, names and pairs.
void describeController(DeviceState& seen);

/// Any other joystick. hats: their last 4 buttons each are up, right, down, left. There is no rotation, and only the
/// first two axes are used: the others may be throttles in any position.
void describeJoystick(DeviceState& seen, int hats);

/// Six axes: translation to the right, towards the person and down, and the rotations about these. stop: of the button
/// Esc; -1: none.
void describeSpaceMouse(DeviceState& seen, int stop);

}  // namespace underact::device::input
