#include "app/gui/input_devices/input_words.h"

#include <QStringList>
#include <algorithm>

#include "app/gui/kit/words.h"
#include "device/input/map_file.h"

namespace underact::gui {

namespace input = device::input;

namespace {

bool setNumber(const QVariant& value, double min, double max, double& into) {
  bool is_number = false;
  const double number = value.toDouble(&is_number);
  if (!is_number || !(number >= min && number <= max)) return false;
  into = number;
  return true;
}

bool setPart(input::AxisMap& map, const QString& part, const QVariant& value, bool turns) {
  if (part == "inverted") {
    map.inverted = value.toBool();
    return value.canConvert<bool>();
  }
  if (part == "dead_zone") return setNumber(value, 0.0, input::kFurthestDeadZone, map.dead_zone);
  if (part == "exponent") return setNumber(value, 1.0, input::kFinest, map.exponent);
  if (part == "top") return setNumber(value, 0.0, turns ? input::kFastest_rad_per_s : input::kFastest_m_per_s, map.top);
  const std::optional<input::Source> source = input::sourceOf(value.toString().toStdString());
  if (part != "source" || !source) return false;
  map.source = *source;
  return true;
}

}  // namespace

QString motionAxisTitle(input::MotionAxis motion) {
  static const char* const kTitles[input::kMotionAxes] = {
      QT_TR_NOOP("Right, left"), QT_TR_NOOP("Up, down"), QT_TR_NOOP("Nearer, farther"),
      QT_TR_NOOP("Pitch"),       QT_TR_NOOP("Yaw"),      QT_TR_NOOP("Roll")};
  return tr(kTitles[static_cast<std::size_t>(motion)]);
}

QString motionAxisPrompt(input::MotionAxis motion) {
  static const char* const kGoals[input::kMotionAxes] = {QT_TR_NOOP("moves the stylus to the right"),
                                                         QT_TR_NOOP("moves the stylus up"),
                                                         QT_TR_NOOP("moves the stylus towards you"),
                                                         QT_TR_NOOP("tilts the top of the stylus towards you"),
                                                         QT_TR_NOOP("turns the front of the stylus to the right"),
                                                         QT_TR_NOOP("tilts the top of the stylus to the left")};
  return tr(kGoals[static_cast<std::size_t>(motion)]);
}

QString pressTitle(input::ButtonRole press) {
  static const char* const kTitles[input::kPresses] = {QT_TR_NOOP("Stylus button 1"), QT_TR_NOOP("Stylus button 2"),
                                                       QT_TR_NOOP("Stop")};
  return tr(kTitles[static_cast<std::size_t>(press)]);
}

QString kindText(input::InputKind kind) {
  switch (kind) {
    case input::InputKind::Controller:
      return tr("game controller");
    case input::InputKind::Joystick:
      return tr("joystick");
    case input::InputKind::SpaceMouse:
      return tr("3D mouse");
  }
  return {};
}

QString axisText(const input::DeviceState& seen, int axis) {
  if (axis < 0) return tr("nothing");
  const auto index = static_cast<std::size_t>(axis);
  return index < seen.axis_names.size() ? sentenceText(seen.axis_names[index]) : tr("axis %1").arg(axis + 1);
}

QString buttonText(const input::DeviceState& seen, int button) {
  if (button < 0) return tr("nothing");
  const auto index = static_cast<std::size_t>(button);
  const QString name = index < seen.button_names.size() ? sentenceText(seen.button_names[index]) : QString();
  return name.isEmpty() ? tr("button %1").arg(button + 1) : name;
}

QString sourceTitle(const input::DeviceState& seen, const input::Source& source) {
  const auto both = [](const QString& there, const QString& back) { return QString("%1 / %2").arg(there, back); };
  switch (source.kind) {
    case input::SourceKind::None:
      return tr("nothing");
    case input::SourceKind::Axis:
      return axisText(seen, source.plus);
    case input::SourceKind::Buttons:
      return both(buttonText(seen, source.plus), buttonText(seen, source.minus));
    case input::SourceKind::Triggers:
      return both(axisText(seen, source.plus), axisText(seen, source.minus));
  }
  return {};
}

std::vector<input::Source> sourcesFor(const input::DeviceState& seen, const input::Source& now) {
  std::vector<input::Source> sources{{}};
  for (int axis = 0; axis < std::min(seen.readings.axes, input::kMaxAxes); ++axis)
    sources.push_back({input::SourceKind::Axis, axis, -1});
  sources.insert(sources.end(), seen.pairs.begin(), seen.pairs.end());
  if (std::find(sources.begin(), sources.end(), now) == sources.end()) sources.push_back(now);
  return sources;
}

std::optional<input::Map> withField(const input::Map& map, const QString& field, const QVariant& value) {
  input::Map next = map;
  const QStringList parts = field.split('.');
  for (std::size_t press = 0; press < input::kPresses; ++press) {
    if (field != input::pressName(static_cast<input::ButtonRole>(press))) continue;
    bool is_number = false;
    const int button = value.toInt(&is_number);
    if (!is_number || button < -1 || button >= input::kMaxButtons) return {};
    next.presses[press] = button;
    return next;
  }
  for (std::size_t motion = 0; motion < input::kMotionAxes; ++motion) {
    if (parts.size() != 2 || parts[0] != input::motionAxisName(static_cast<input::MotionAxis>(motion))) continue;
    if (setPart(next.motions[motion], parts[1], value, motion >= input::kMoves)) return next;
  }
  return {};
}

}  // namespace underact::gui
