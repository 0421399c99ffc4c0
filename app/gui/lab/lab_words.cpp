#include "app/gui/lab/lab_words.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "app/gui/kit/number_box.h"

namespace underact::gui {
namespace {

/// Three significant digits, without an exponent.
QString shortText(double value) {
  if (value == 0.0) return "0";
  const int before = static_cast<int>(std::floor(std::log10(std::abs(value))));
  int decimals = std::clamp(2 - before, 0, 9);
  for (QString text = QString::number(value, 'f', decimals); decimals > 0 && text.endsWith('0'); text.chop(1))
    --decimals;
  return localNumber(value, 'f', decimals);
}

struct Name {
  const char *key, *name;
};

constexpr Name kNames[] = {{"rate", QT_TRANSLATE_NOOP("choice", "Servo rate")},
                           {"simulation", QT_TRANSLATE_NOOP("choice", "Simulated arm")},
                           {"search", QT_TRANSLATE_NOOP("choice", "Search")},
                           {"solver", QT_TRANSLATE_NOOP("choice", "Solver")},
                           {"steps", QT_TRANSLATE_NOOP("choice", "Solver steps")},
                           {"velocity", QT_TRANSLATE_NOOP("choice", "Velocity filter")},
                           {"inverse", QT_TRANSLATE_NOOP("choice", "Inverse kinematics")},
                           {"blocks", QT_TRANSLATE_NOOP("choice", "Recording blocks")}};

}  // namespace

QString timeText(double us) {
  if (us >= 1e6) return QObject::tr("%1 s").arg(shortText(1e-6 * us));
  if (us >= 1e3) return QObject::tr("%1 ms").arg(shortText(1e-3 * us));
  if (us >= 1.0) return QObject::tr("%1 µs").arg(shortText(us));
  return QObject::tr("%1 ns").arg(shortText(1e3 * us));
}

QString lengthText(double mm) {
  if (mm == 0.0) return QObject::tr("0 mm");
  if (mm >= 0.1) return QObject::tr("%1 mm").arg(shortText(mm));
  if (mm >= 1e-4) return QObject::tr("%1 µm").arg(shortText(1e3 * mm));
  if (mm < 1e-9) return QObject::tr("below 0.001 nm");  // far below what any number here is true to
  return QObject::tr("%1 nm").arg(shortText(1e6 * mm));
}

QString errorText(double error, const QString& unit) {
  return unit == "mm" ? lengthText(error) : QString("%1 %2").arg(shortText(error), unit);
}

QString durationText(double seconds) {
  if (seconds < 1.5) return QObject::tr("a second");
  if (seconds < 90.0)
    return QObject::tr("%1 s").arg(std::lround(seconds < 20.0 ? seconds : 5.0 * std::round(seconds / 5.0)));
  return QObject::tr("%1 min").arg(std::lround(seconds / 60.0));
}

QString optionText(const std::string& name) {
  QString text = QString::fromStdString(name);
  static const QString kWhere = "closed form where there is one, else ";
  if (text.startsWith(kWhere))
    return QObject::tr("closed form where there is one, else %1").arg(text.mid(kWhere.size()));
  if (text == "closed form") return QObject::tr("closed form");
  if (text.endsWith(" us")) text.replace(text.size() - 2, 2, QObject::tr("µs"));
  return text;
}

QString choiceName(const tradeoff::Choice& choice) {
  for (const Name& one : kNames) {
    if (QString(one.key) == choice.key) return QCoreApplication::translate("choice", one.name);
  }
  return choice.key;  // a choice without a name here
}

}  // namespace underact::gui
