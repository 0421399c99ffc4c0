#pragma once
#include <QString>
#include <QVariant>
#include <optional>
#include <vector>

#include "device/hands/port.h"

namespace underact::gui {

/// "Right, left"
QString wayTitle(device::hands::Way way);
/// What the way does: "moves the stylus to the right"
QString wayGoal(device::hands::Way way);
/// "Stylus button 1"
QString pressTitle(device::hands::Press press);
QString kindText(device::hands::Kind kind);

/// "left stick, right"; "axis 3" if it has no name.
QString axisText(const device::hands::Seen& seen, int axis);
QString buttonText(const device::hands::Seen& seen, int button);
QString sourceTitle(const device::hands::Seen& seen, const device::hands::Source& source);

/// The possible sources of a way, including the present one.
std::vector<device::hands::Source> sourcesFor(const device::hands::Seen& seen, const device::hands::Source& now);

/// The map with one field as a command says it: "right.source" "axis 0", "right.inverted" true, "right.dead_zone" 0.2,
/// "right.exponent" 2, "right.top" 0.1 (m/s, rad/s), "stop" 3 (a button; -1: none). None: no such field, or not a value
/// of it.
std::optional<device::hands::Map> withField(const device::hands::Map& map, const QString& field, const QVariant& value);

}  // namespace underact::gui
