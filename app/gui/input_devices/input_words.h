#pragma once
#include <QString>
#include <QVariant>
#include <optional>
#include <vector>

#include "device/input/device_enumerator.h"

namespace underact::gui {

/// "Right, left"
QString motionAxisTitle(device::input::MotionAxis motion);
/// What the way does: "moves the stylus to the right"
QString motionAxisPrompt(device::input::MotionAxis motion);
/// "Stylus button 1"
QString pressTitle(device::input::ButtonRole press);
QString kindText(device::input::InputKind kind);

/// "left stick, right"; "axis 3" if it has no name.
QString axisText(const device::input::DeviceState& seen, int axis);
QString buttonText(const device::input::DeviceState& seen, int button);
QString sourceTitle(const device::input::DeviceState& seen, const device::input::Source& source);

/// The possible sources of a way, including the present one.
std::vector<device::input::Source> sourcesFor(const device::input::DeviceState& seen, const device::input::Source& now);

/// The map with one field as a command says it: "right.source" "axis 0", "right.inverted" true, "right.dead_zone" 0.2,
/// "right.exponent" 2, "right.top" 0.1 (m/s, rad/s), "stop" 3 (a button; -1: none). None: no such field, or not a value
/// of it.
std::optional<device::input::Map> withField(const device::input::Map& map, const QString& field, const QVariant& value);

}  // namespace underact::gui
