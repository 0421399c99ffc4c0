#pragma once
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "device/driver.h"
#include "device/input/motion.h"

namespace underact::device::input {

enum class InputKind : std::uint8_t { Controller, Joystick, SpaceMouse };

/// An input device that is plugged in.
struct DeviceState {
  std::string id;  // the same every time it is plugged in
  Sentence name;   // "Xbox Controller"
  InputKind kind = InputKind::Joystick;
  Readings readings;
  std::vector<Sentence> axis_names, button_names;  // "left stick, right"; may be shorter: the others have numbers
  std::vector<Source> pairs;                       // of buttons and triggers that belong together
  Map default_value;                               // the default mapping
  std::vector<Missing> missing;                    // empty: it can be read
};

/// All input devices of one kind on a computer.
class DeviceEnumerator {
 public:
  virtual ~DeviceEnumerator() = default;
  /// The present devices and their readings; never waits. The window's thread.
  virtual std::vector<DeviceState> poll() = 0;
  /// Why no device of this kind can be used here, and what still works; empty: nothing is wrong.
  virtual Sentence trouble() const { return {}; }
};

/// Makes equal ids different: "ID", "ID-2", ...
void makeIdsUnique(std::vector<DeviceState>& seen);

}  // namespace underact::device::input
