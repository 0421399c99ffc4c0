#include "device/input/controllers.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#undef GLFW_INCLUDE_NONE

#include <algorithm>

#include "core/base/translate.h"
#include "device/input/default_maps.h"
#include "device/input/space_mouse.h"

namespace underact::device::input {
namespace {

void takeAxes(const float* values, int count, Readings& readings) {
  readings.axes = std::min(count, kMaxAxes);
  for (int axis = 0; axis < readings.axes; ++axis) readings.axis[static_cast<std::size_t>(axis)] = values[axis];
}

void takeButtons(const unsigned char* values, int count, Readings& readings) {
  readings.buttons = std::min(count, kMaxButtons);
  for (int button = 0; button < readings.buttons; ++button) {
    if (values[button] == GLFW_PRESS) readings.pressed |= std::uint64_t{1} << static_cast<unsigned>(button);
  }
}

std::string textOf(const char* text) {
  return text == nullptr ? std::string() : text;
}

/// Null if it was unplugged this moment: then there are no axes.
void describeAny(int joystick, DeviceState& seen) {
  GLFWgamepadstate pad{};
  if (::glfwGetGamepadState(joystick, &pad) == GLFW_TRUE) {
    seen.kind = InputKind::Controller;
    seen.name = textOf(::glfwGetGamepadName(joystick));
    takeAxes(pad.axes, GLFW_GAMEPAD_AXIS_LAST + 1, seen.readings);
    takeButtons(pad.buttons, GLFW_GAMEPAD_BUTTON_LAST + 1, seen.readings);
    return describeController(seen);
  }
  seen.kind = InputKind::Joystick;
  seen.name = textOf(::glfwGetJoystickName(joystick));
  int axes = 0, buttons = 0, hats = 0;
  const float* const values = ::glfwGetJoystickAxes(joystick, &axes);
  const unsigned char* const pressed = ::glfwGetJoystickButtons(joystick, &buttons);
  const unsigned char* const hat_values = ::glfwGetJoystickHats(joystick, &hats);
  if (values != nullptr) takeAxes(values, axes, seen.readings);
  if (pressed != nullptr) takeButtons(pressed, buttons, seen.readings);
  describeJoystick(seen, hat_values == nullptr ? 0 : hats);
}

}  // namespace

Controllers::~Controllers() {
  if (works_) ::glfwTerminate();
}

bool Controllers::begin() {
  if (has_begun_) return works_;
  has_begun_ = true;
  ::glfwInitHint(GLFW_JOYSTICK_HAT_BUTTONS, GLFW_TRUE);
  works_ = ::glfwInit() == GLFW_TRUE;
  if (works_) return true;
  const char* why = nullptr;
  ::glfwGetError(&why);
  trouble_ = phrase(TRANSLATE_NOOP("problem",
                                   "Game controllers cannot be read here (%1). Mouse, keyboard and 3D mice still work. "
                                   "Controllers need an X11 display, or a Wayland desktop with Xwayland."),
                    {why == nullptr ? phrase(TRANSLATE_NOOP("problem", "no reason given")) : Sentence(why)});
  return false;
}

std::vector<DeviceState> Controllers::poll() {
  std::vector<DeviceState> all;
  if (!begin()) return all;
  ::glfwPollEvents();  // notices what was plugged in or out
  for (int joystick = GLFW_JOYSTICK_1; joystick <= GLFW_JOYSTICK_LAST; ++joystick) {
    if (::glfwJoystickPresent(joystick) != GLFW_TRUE) continue;
    DeviceState seen;
    seen.id = textOf(::glfwGetJoystickGUID(joystick));
    if (isSpaceMouseGuid(seen.id)) continue;
    describeAny(joystick, seen);
    if (seen.id.empty() || seen.readings.axes + seen.readings.buttons == 0) continue;  // unplugged this moment
    all.push_back(std::move(seen));
  }
  makeIdsUnique(all);
  return all;
}

}  // namespace underact::device::input
