#pragma once
#include "device/hands/port.h"

namespace underact::device::hands {

/// A controller with the buttons and sticks of a gamepad, in GLFW's order: usual map, names and pairs.
void describeController(Seen& seen);

/// Any other joystick. hats: the last 4 buttons are of each: up, right, down, left. Nothing is turned, and only the
/// first two axes are used: the others may be throttles that stand anywhere.
void describeJoystick(Seen& seen, int hats);

/// Six axes: shift right, towards the person and down, and the turns about these. stop: of the button Esc; -1: none.
void describeSpaceMouse(Seen& seen, int stop);

}  // namespace underact::device::hands
