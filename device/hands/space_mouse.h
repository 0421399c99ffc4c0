#pragma once
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/sentence.h"
#include "device/hands/motion.h"
#include "device/wooden/hid_bus.h"

namespace underact::device::hands {

/// A 3D mouse that is known.
struct SpaceMouseModel {
  std::uint16_t vendor = 0, product = 0;
  const char* name = "";
  std::span<const char* const> buttons;  // names, by the bit of report 3; "": none is there
};

std::span<const SpaceMouseModel> spaceMouseModels();
/// Or null.
const SpaceMouseModel* findSpaceMouse(std::uint16_t vendor, std::uint16_t product);

/// As a window shows them.
Sentence spaceMouseName(const SpaceMouseModel& model);
std::vector<Sentence> buttonNames(const SpaceMouseModel& model);

/// Whether a HID device is the part of a known 3D mouse that says how it is moved: page 1, usage 8; or may be, as long
/// as nobody may open it. A receiver has others.
bool isSpaceMouse(const HidNode& node);

/// Whether GLFW's name of a joystick ("03000000" "6d040000" "26c60000" ...) is that of a known 3D mouse, which is read
/// better as itself.
bool isSpaceMouseGuid(std::string_view guid);

/// What a report says, into readings of six axes: shift right, towards the person, down, and the turns about them.
/// Reports: 1 shift, or with 12 bytes shift and turn; 2 turn; 3 buttons; of others nothing is taken up. Any bytes.
enum class SpaceMouseReport : std::uint8_t { Other, Moved, Buttons };
SpaceMouseReport takeSpaceMouseReport(std::span<const std::uint8_t> report, Readings& readings);

/// The button "Esc" of a model; -1: it has none.
int escButton(const SpaceMouseModel& model);

}  // namespace underact::device::hands
