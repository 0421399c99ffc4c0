#include "app/gui/hands/hand_words.h"

#include <QStringList>
#include <algorithm>

#include "app/gui/kit/words.h"
#include "device/hands/map_file.h"

namespace underact::gui {

namespace hands = device::hands;

namespace {

bool setNumber(const QVariant& value, double least, double most, double& into) {
  bool is_number = false;
  const double number = value.toDouble(&is_number);
  if (!is_number || !(number >= least && number <= most)) return false;
  into = number;
  return true;
}

bool setPart(hands::AxisMap& map, const QString& part, const QVariant& value, bool turns) {
  if (part == "inverted") {
    map.inverted = value.toBool();
    return value.canConvert<bool>();
  }
  if (part == "dead_zone") return setNumber(value, 0.0, hands::kFurthestDeadZone, map.dead_zone);
  if (part == "exponent") return setNumber(value, 1.0, hands::kFinest, map.exponent);
  if (part == "top") return setNumber(value, 0.0, turns ? hands::kFastest_rad_per_s : hands::kFastest_m_per_s, map.top);
  const std::optional<hands::Source> source = hands::sourceOf(value.toString().toStdString());
  if (part != "source" || !source) return false;
  map.source = *source;
  return true;
}

}  // namespace

QString wayTitle(hands::Way way) {
  static const char* const kTitles[hands::kWays] = {
      QT_TR_NOOP("Right, left"), QT_TR_NOOP("Up, down"), QT_TR_NOOP("Nearer, farther"),
      QT_TR_NOOP("Pitch"),       QT_TR_NOOP("Yaw"),      QT_TR_NOOP("Roll")};
  return tr(kTitles[static_cast<std::size_t>(way)]);
}

QString wayGoal(hands::Way way) {
  static const char* const kGoals[hands::kWays] = {QT_TR_NOOP("moves the stylus to the right"),
                                                   QT_TR_NOOP("moves the stylus up"),
                                                   QT_TR_NOOP("moves the stylus towards you"),
                                                   QT_TR_NOOP("tilts the top of the stylus towards you"),
                                                   QT_TR_NOOP("turns the front of the stylus to the right"),
                                                   QT_TR_NOOP("tilts the top of the stylus to the left")};
  return tr(kGoals[static_cast<std::size_t>(way)]);
}

QString pressTitle(hands::Press press) {
  static const char* const kTitles[hands::kPresses] = {QT_TR_NOOP("Stylus button 1"), QT_TR_NOOP("Stylus button 2"),
                                                       QT_TR_NOOP("Stop")};
  return tr(kTitles[static_cast<std::size_t>(press)]);
}

QString kindText(hands::Kind kind) {
  switch (kind) {
    case hands::Kind::Controller:
      return tr("game controller");
    case hands::Kind::Joystick:
      return tr("joystick");
    case hands::Kind::SpaceMouse:
      return tr("3D mouse");
  }
  return {};
}

QString axisText(const hands::Seen& seen, int axis) {
  if (axis < 0) return tr("nothing");
  const auto index = static_cast<std::size_t>(axis);
  return index < seen.axis_names.size() ? sentenceText(seen.axis_names[index]) : tr("axis %1").arg(axis + 1);
}

QString buttonText(const hands::Seen& seen, int button) {
  if (button < 0) return tr("nothing");
  const auto index = static_cast<std::size_t>(button);
  const QString name = index < seen.button_names.size() ? sentenceText(seen.button_names[index]) : QString();
  return name.isEmpty() ? tr("button %1").arg(button + 1) : name;
}

QString sourceTitle(const hands::Seen& seen, const hands::Source& source) {
  const auto both = [](const QString& there, const QString& back) { return QString("%1 / %2").arg(there, back); };
  switch (source.kind) {
    case hands::SourceKind::None:
      return tr("nothing");
    case hands::SourceKind::Axis:
      return axisText(seen, source.plus);
    case hands::SourceKind::Buttons:
      return both(buttonText(seen, source.plus), buttonText(seen, source.minus));
    case hands::SourceKind::Triggers:
      return both(axisText(seen, source.plus), axisText(seen, source.minus));
  }
  return {};
}

std::vector<hands::Source> sourcesFor(const hands::Seen& seen, const hands::Source& now) {
  std::vector<hands::Source> sources{{}};
  for (int axis = 0; axis < std::min(seen.readings.axes, hands::kMostAxes); ++axis)
    sources.push_back({hands::SourceKind::Axis, axis, -1});
  sources.insert(sources.end(), seen.pairs.begin(), seen.pairs.end());
  if (std::find(sources.begin(), sources.end(), now) == sources.end()) sources.push_back(now);
  return sources;
}

std::optional<hands::Map> withField(const hands::Map& map, const QString& field, const QVariant& value) {
  hands::Map next = map;
  const QStringList parts = field.split('.');
  for (std::size_t press = 0; press < hands::kPresses; ++press) {
    if (field != hands::pressName(static_cast<hands::Press>(press))) continue;
    bool is_number = false;
    const int button = value.toInt(&is_number);
    if (!is_number || button < -1 || button >= hands::kMostButtons) return {};
    next.presses[press] = button;
    return next;
  }
  for (std::size_t way = 0; way < hands::kWays; ++way) {
    if (parts.size() != 2 || parts[0] != hands::wayName(static_cast<hands::Way>(way))) continue;
    if (setPart(next.ways[way], parts[1], value, way >= hands::kMoves)) return next;
  }
  return {};
}

}  // namespace underact::gui
