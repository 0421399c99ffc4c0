#include "app/gui/kit/gain_row.h"

#include <QCoreApplication>

namespace underact::gui {
namespace {

constexpr double kLargest = 1e6;

QString translated(const char* text) {
  return QCoreApplication::translate("gain", text);
}

ValueKind valueKindOf(const GainKind& gain) {
  return {translated(gain.tip), QString(gain.unit), gain.steps_per_unit, gain.slider_steps, gain.decimals, kLargest};
}

}  // namespace

const GainKind& gainKind(int gain) {
  static const GainKind kKinds[kGainKinds] = {
      {"kp", QT_TRANSLATE_NOOP("gain", "Stiffness"),
       QT_TRANSLATE_NOOP("gain",
                         "How hard the stylus is pulled back for each millimetre: f = kp e (proportional gain)."),
       "N/mm", 100, 200, 3},
      {"kd", QT_TRANSLATE_NOOP("gain", "Damping"),
       QT_TRANSLATE_NOOP("gain", "How hard a change of the error is resisted: f = kd de/dt (derivative gain)."),
       "N s/mm", 10000, 100, 5},
      {"ki", QT_TRANSLATE_NOOP("gain", "Integral"),
       QT_TRANSLATE_NOOP("gain", "How fast an error that stays is worked off: df/dt = ki e (integral gain)."),
       "N/(mm s)", 100, 500, 3}};
  return kKinds[gain];
}

GainRow::GainRow(int gain, int axis, QWidget* parent)
    : ValueRow(valueKindOf(gainKind(gain)), QString("panel.gains.%1.%2").arg(gainKind(gain).key).arg(QChar('x' + axis)),
               parent),
      gain_(gainKind(gain)) {
  setAxisName(QChar('x' + axis));
}

void GainRow::setAxisName(const QString& axis) {
  setLabel(axis, QString("%1 %2").arg(translated(gain_.name), axis), "q1");
}

}  // namespace underact::gui
