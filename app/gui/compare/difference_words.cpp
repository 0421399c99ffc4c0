#include "app/gui/compare/difference_words.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "app/gui/kit/words.h"
#include "app/gui/model/setting_words.h"

namespace underact::gui {
namespace {

struct KeyName {
  const char *key, *name;
};

/// Keys of shapes and scenes that are no settings, without their unit.
constexpr std::array kKeyNames{KeyName{"center", QT_TRANSLATE_NOOP("difference", "centre")},
                               KeyName{"radius", QT_TRANSLATE_NOOP("difference", "radius")},
                               KeyName{"position", QT_TRANSLATE_NOOP("difference", "position")},
                               KeyName{"point", QT_TRANSLATE_NOOP("difference", "point on it")},
                               KeyName{"direction", QT_TRANSLATE_NOOP("difference", "direction")},
                               KeyName{"normal", QT_TRANSLATE_NOOP("difference", "normal")},
                               KeyName{"axis", QT_TRANSLATE_NOOP("difference", "axis")},
                               KeyName{"size", QT_TRANSLATE_NOOP("difference", "size")},
                               KeyName{"R_WB", QT_TRANSLATE_NOOP("difference", "orientation")},
                               KeyName{"type", QT_TRANSLATE_NOOP("difference", "type")},
                               KeyName{"name", QT_TRANSLATE_NOOP("difference", "name")},
                               KeyName{"file", QT_TRANSLATE_NOOP("difference", "file")},
                               KeyName{"arm", QT_TRANSLATE_NOOP("difference", "arm")},
                               KeyName{"joints", QT_TRANSLATE_NOOP("difference", "joints")},
                               KeyName{"constraints", QT_TRANSLATE_NOOP("difference", "constraints")},
                               KeyName{"control", QT_TRANSLATE_NOOP("difference", "control law and gains")},
                               KeyName{"influence", QT_TRANSLATE_NOOP("difference", "influence")},
                               KeyName{"velocity", QT_TRANSLATE_NOOP("difference", "velocity filter")},
                               KeyName{"friction", QT_TRANSLATE_NOOP("difference", "friction")},
                               KeyName{"solver", QT_TRANSLATE_NOOP("difference", "solver")},
                               KeyName{"X_WV_home", QT_TRANSLATE_NOOP("difference", "home pose")}};

constexpr std::array kUnits{KeyName{"_mm_per_s2", "mm/s²"}, KeyName{"_mm_per_s", "mm/s"}, KeyName{"_mm", "mm"},
                            KeyName{"_deg", "°"},           KeyName{"_ms", "ms"},         KeyName{"_us", "µs"}};

/// The words for a key that is no setting, and its unit.
std::pair<QString, QString> keyWords(QString key) {
  QString unit;
  for (const KeyName& one : kUnits) {
    if (!key.endsWith(one.key)) continue;
    unit = QString::fromUtf8(one.name);
    key.chop(static_cast<int>(qstrlen(one.key)));
    break;
  }
  const auto named =
      std::find_if(kKeyNames.begin(), kKeyNames.end(), [&](const KeyName& one) { return key == one.key; });
  if (named != kKeyNames.end()) return {QCoreApplication::translate("difference", named->name), unit};
  return {key.replace('_', ' '), unit};
}

QString valueWords(const std::string& value, const std::string& path, const QString& unit) {
  if (value.empty()) return tr("not set");
  const QString word = settingChoice(path, value);
  if (!word.isEmpty()) return word;
  QString text = QString::fromStdString(value);
  return unit.isEmpty() ? text : text + (unit == "°" ? QString() : QString(" ")) + unit;
}

}  // namespace

DifferenceWords differenceWords(const scene::Difference& difference) {
  QStringList parts = QString::fromStdString(difference.key).split('.');
  // A setting of the scene, or one of a constraint, whose name comes first.
  std::string path = "/" + parts.join('/').toStdString();
  QString of;
  if (settingLabel(path).isEmpty() && parts.size() > 1) {
    const std::string inside = "/constraints/*/" + parts.mid(1).join('/').toStdString();
    if (!settingLabel(inside).isEmpty() || parts.first() != "control") {
      path = inside;
      of = parts.first();
    }
  }
  QString label = settingLabel(path), unit = settingUnit(path);
  if (label.isEmpty()) std::tie(label, unit) = keyWords(parts.last());
  return {of.isEmpty() ? label : tr("%1 of “%2”").arg(label, of), valueWords(difference.one, path, unit),
          valueWords(difference.other, path, unit)};
}

}  // namespace underact::gui
