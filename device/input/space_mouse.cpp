#include "device/input/space_mouse.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>

#include "core/base/translate.h"

namespace underact::device::input {
namespace {

// Bits of report 3: PySpaceMouse, devices.toml (bytes from 1, eight bits each).
constexpr std::array kTwo{TRANSLATE_NOOP("problem", "left"), TRANSLATE_NOOP("problem", "right")};
constexpr std::array kPro{"Menu", "Fit", "Top", "",  "Right", "Front", "",      "",     "Roll",
                          "",     "",    "",    "1", "2",     "3",     "4",     "",     "",
                          "",     "",    "",    "",  "Esc",   "Alt",   "Shift", "Ctrl", "Rotation"};
constexpr std::array kEnterprise{"Menu", "Fit", "Top", "",   "Right", "Front", "",      "",     "Roll",
                                 "",     "Iso", "",    "1",  "2",     "3",     "4",     "5",    "6",
                                 "7",    "8",   "9",   "10", "Esc",   "Alt",   "Shift", "Ctrl", "Lock"};
constexpr std::array kExplorer{"1",     "2",    "T",   "L",     "R", "F", "Esc", "Alt",
                               "Shift", "Ctrl", "Fit", "Panel", "+", "-", "2D"};
constexpr std::array kPilot{"1",   "2",     "3",    "4",   "5",     "6", "T", "L",   "R",    "F",     "Esc",
                            "Alt", "Shift", "Ctrl", "Fit", "Panel", "-", "+", "Dom", "Lock", "Config"};
constexpr std::array kPilotPro{"Menu", "Fit", "Top",   "",     "Right",    "Front", "",         "",  "Roll", "", "Iso",
                               "",     "",    "",      "3",    "4",        "5",     "1",        "2", "",     "", "",
                               "Esc",  "Alt", "Shift", "Ctrl", "Rotation", "Pan",   "Dominant", "+", "-"};

constexpr std::uint16_t kLogitech = 0x046D, k3dconnexion = 0x256F;

// FreeSpacenav's spacenavd, src/dev.c; PySpaceMouse, devices.toml. Without a table of buttons: by number.
constexpr std::array kModels{
    SpaceMouseModel{kLogitech, 0xC603, "SpaceMouse Plus XT", {}},
    SpaceMouseModel{kLogitech, 0xC605, "CadMan", {}},
    SpaceMouseModel{kLogitech, 0xC606, "SpaceMouse Classic", {}},
    SpaceMouseModel{kLogitech, 0xC621, "Spaceball 5000", {}},
    SpaceMouseModel{kLogitech, 0xC623, "SpaceTraveler", {}},
    SpaceMouseModel{kLogitech, 0xC625, "SpacePilot", kPilot},
    SpaceMouseModel{kLogitech, 0xC626, "SpaceNavigator", kTwo},
    SpaceMouseModel{kLogitech, 0xC627, "SpaceExplorer", kExplorer},
    SpaceMouseModel{kLogitech, 0xC628, "SpaceNavigator for Notebooks", kTwo},
    SpaceMouseModel{kLogitech, 0xC629, "SpacePilot Pro", kPilotPro},
    SpaceMouseModel{kLogitech, 0xC62B, "SpaceMouse Pro", kPro},
    SpaceMouseModel{k3dconnexion, 0xC62E, TRANSLATE_NOOP("problem", "SpaceMouse Wireless (cable)"), kTwo},
    SpaceMouseModel{k3dconnexion, 0xC62F, TRANSLATE_NOOP("problem", "SpaceMouse Wireless (receiver)"), kTwo},
    SpaceMouseModel{k3dconnexion, 0xC631, TRANSLATE_NOOP("problem", "SpaceMouse Pro Wireless (cable)"), kPro},
    SpaceMouseModel{k3dconnexion, 0xC632, TRANSLATE_NOOP("problem", "SpaceMouse Pro Wireless (receiver)"), kPro},
    SpaceMouseModel{k3dconnexion, 0xC633, "SpaceMouse Enterprise", kEnterprise},
    SpaceMouseModel{k3dconnexion, 0xC635, "SpaceMouse Compact", kTwo},
    SpaceMouseModel{k3dconnexion, 0xC636, "SpaceMouse Module", {}},
    SpaceMouseModel{k3dconnexion, 0xC638, "SpaceMouse Pro Wireless (Bluetooth)", kPro},
    SpaceMouseModel{k3dconnexion, 0xC63A, "SpaceMouse Wireless (Bluetooth)", kTwo},
    SpaceMouseModel{k3dconnexion, 0xC652, "3Dconnexion Universal Receiver", kPro},
};

constexpr double kFullWay = 350.0;            // logical; facts on devices, 3.3
constexpr std::size_t kThree = 7, kSix = 13;  // bytes of a report, its id among them
constexpr std::uint16_t kDesktopPage = 1, kMultiAxis = 8;

/// Axes from `first` on, from the bytes from 1 on.
void takeAxisBytes(std::span<const std::uint8_t> report, std::size_t first, std::size_t count, Readings& readings) {
  for (std::size_t axis = 0; axis < count; ++axis) {
    const unsigned low = report[1 + 2 * axis], high = report[2 + 2 * axis];
    const auto value = static_cast<std::int16_t>(low | high << 8U);
    readings.axis[first + axis] = std::clamp(static_cast<double>(value) / kFullWay, -1.0, 1.0);
  }
}

/// Of a GUID's bytes, as text: "6d04" is 0x046D.
std::optional<std::uint16_t> idAt(std::string_view guid, std::size_t at) {
  if (guid.size() < at + 4) return {};
  unsigned low = 0, high = 0;
  const auto byte = [&](std::size_t from, unsigned& into) {
    const std::from_chars_result read = std::from_chars(guid.data() + from, guid.data() + from + 2, into, 16);
    return read.ec == std::errc() && read.ptr == guid.data() + from + 2;
  };
  if (!byte(at, low) || !byte(at + 2, high)) return {};
  return static_cast<std::uint16_t>(low | high << 8U);
}

}  // namespace

std::span<const SpaceMouseModel> spaceMouseModels() {
  return kModels;
}

const SpaceMouseModel* findSpaceMouse(std::uint16_t vendor, std::uint16_t product) {
  const auto* const found = std::find_if(kModels.begin(), kModels.end(), [=](const SpaceMouseModel& model) {
    return model.vendor == vendor && model.product == product;
  });
  return found == kModels.end() ? nullptr : &*found;
}

// A product's name is the same in every language, unless it states how the mouse is connected.
Sentence spaceMouseName(const SpaceMouseModel& model) {
  const std::string_view name(model.name);
  return name.ends_with("(cable)") || name.ends_with("(receiver)") ? phrase(model.name) : Sentence(model.name);
}

// Names where nothing is printed on the buttons.
std::vector<Sentence> buttonNames(const SpaceMouseModel& model) {
  std::vector<Sentence> names(model.buttons.begin(), model.buttons.end());
  if (model.buttons.data() == kTwo.data())
    std::transform(names.begin(), names.end(), names.begin(), [](const Sentence& name) { return phrase(name); });
  return names;
}

bool isSpaceMouse(const HidNode& node) {
  if (findSpaceMouse(node.vendor, node.product) == nullptr) return false;
  const bool is_unknown = node.usage_page == 0 && node.usage == 0;
  return is_unknown || (node.usage_page == kDesktopPage && node.usage == kMultiAxis);
}

// GLFW 3.3 on Linux: bus, vendor and product as 16 bits each, low byte first, each followed by 16 zero bits.
bool isSpaceMouseGuid(std::string_view guid) {
  const std::optional<std::uint16_t> vendor = idAt(guid, 8), product = idAt(guid, 16);
  return vendor && product && findSpaceMouse(*vendor, *product) != nullptr;
}

SpaceMouseReport readSpaceMouseReport(std::span<const std::uint8_t> report, Readings& readings) {
  readings.axes = 6;
  if (report.empty()) return SpaceMouseReport::Other;
  if (report[0] == 1 && report.size() >= kThree) {
    takeAxisBytes(report, 0, report.size() >= kSix ? 6 : 3, readings);
    return SpaceMouseReport::Moved;
  }
  if (report[0] == 2 && report.size() >= kThree) {
    takeAxisBytes(report, 3, 3, readings);
    return SpaceMouseReport::Moved;
  }
  if (report[0] == 3) {
    readings.pressed = 0;
    for (std::size_t byte = 1; byte < std::min<std::size_t>(report.size(), 9); ++byte) {
      readings.pressed |= static_cast<std::uint64_t>(report[byte]) << (8U * (byte - 1));
    }
    return SpaceMouseReport::Buttons;
  }
  return SpaceMouseReport::Other;
}

int escButton(const SpaceMouseModel& model) {
  for (std::size_t bit = 0; bit < model.buttons.size(); ++bit) {
    if (std::string_view(model.buttons[bit]) == "Esc") return static_cast<int>(bit);
  }
  return -1;
}

}  // namespace underact::device::input
