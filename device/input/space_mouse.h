#pragma once
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/sentence.h"
#include "device/input/motion.h"
#include "device/wooden_haptics/hid_bus.h"

namespace underact::device::input {

/// A known 3D mouse.
struct SpaceMouseModel {
  std::uint16_t vendor = 0, product = 0;
  const char* name = "";
  std::span<const char* const> buttons;  // names, by the bit of report 3; "": no such button
};

std::span<const SpaceMouseModel> spaceMouseModels();
/// Or null.
const SpaceMouseModel* findSpaceMouse(std::uint16_t vendor, std::uint16_t product);

/// As a window shows them.
Sentence spaceMouseName(const SpaceMouseModel& model);
std::vector<Sentence> buttonNames(const SpaceMouseModel& model);

/// Whether a HID device is the interface of a known 3D mouse that reports motion: page 1, usage 8; or may be, while
/// nobody may open it. A receiver has others, too.
bool isSpaceMouse(const HidNode& node);

/// Whether GLFW's name of a joystick ("03000000" "6d040000" "26c60000" ...) is that of a known 3D mouse, which is
/// better read directly.
bool isSpaceMouseGuid(std::string_view guid);

/// Takes a report into the readings of six axes: translation to the right, towards the person, down, and the rotations
/// about these. Reports: 1 translation, or with 12 bytes translation and rotation; 2 rotation; 3 buttons; others are
/// ignored. Any bytes.
enum class SpaceMouseReport : std::uint8_t { Other, Moved, Buttons };
SpaceMouseReport readSpaceMouseReport(std::span<const std::uint8_t> report, Readings& readings);

/// The button "Esc" of a model; -1: it has none.
int escButton(const SpaceMouseModel& model);

}  // namespace underact::device::input
