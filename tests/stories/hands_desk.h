#pragma once
#include <gtest/gtest.h>

#include <QDir>
#include <QLabel>
#include <QStandardPaths>

#include "app/gui/input_devices/input_devices.h"
#include "device/input/default_maps.h"
#include "device/simulated_arm.h"
#include "tests/stories/story.h"

namespace underact::gui::test {

using namespace device::input;

inline constexpr const char* kPad = "030000005e0400008e02000010010000";

/// A game controller that does what a story says.
class ScriptedPad final : public DeviceEnumerator {
 public:
  ScriptedPad() {
    pad.id = kPad;
    pad.name = "Xbox 360 Controller";
    pad.kind = device::input::InputKind::Controller;
    pad.readings.axes = 6;
    pad.readings.buttons = 15;
    describeController(pad);
    rest();
  }
  std::vector<DeviceState> poll() override { return is_plugged ? std::vector{pad} : std::vector<DeviceState>{}; }
  Sentence trouble() const override { return its_trouble; }
  void push(std::size_t axis, double value) { pad.readings.axis[axis] = value; }
  void press(unsigned bits) { pad.readings.pressed = bits; }
  void rest() {
    pad.readings.axis = {0, 0, 0, 0, -1, -1};
    pad.readings.pressed = 0;
  }
  DeviceState pad;
  bool is_plugged = true;
  std::string its_trouble;
};

/// Where maps are kept.
inline QString mapFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) + "/hands";
}

/// A window with a controller beside it.
struct HandsDesk {
  explicit HandsDesk(bool first_start = true) : story_(begin(first_start)) {
    story().perform("dock.hands", true);
    story().perform("session.start");
    story().run(500);
  }
  std::unique_ptr<Story> begin(bool first_start) {
    if (first_start) QDir(mapFolder()).removeRecursively();
    return std::make_unique<Story>("02_sphere", Beginning{.first_start = first_start, .hands = {&pad}});
  }
  Story& story() { return *story_; }
  InputDevices& hands() { return *story().window().findChild<InputDevices*>(); }
  const Map& map() { return hands().find(kPad)->map; }
  Vec3 setpoint() { return story().arm().setpoint().p_WT; }
  QString label(const char* name) { return story().find<QLabel>(name)->text(); }
  /// The pad as it is now for so many ticks.
  void hold(int ticks) { story().run(ticks); }

  ScriptedPad pad;
  std::unique_ptr<Story> story_;
};

inline bool comes(const std::function<bool()>& what) {
  return QTest::qWaitFor(what, kLong_ms);
}

}  // namespace underact::gui::test
