#include "app/gui/feature/gain_row.h"

#include <QCoreApplication>

#include "app/gui/model/setting_words.h"

namespace underact::gui {
namespace {

constexpr double kLargest = 1e6;

QString translated(const char* text) {
  return QCoreApplication::translate("gain", text);
}

ValueKind valueKindOf(const GainKind& gain) {
  return {settingTip(gain.path), QString(gain.unit), gain.steps_per_unit, gain.slider_steps, gain.decimals, kLargest};
}

}  // namespace

const GainKind& gainKind(int gain) {
  static const GainKind kKinds[kGainKinds] = {
      {"kp", QT_TRANSLATE_NOOP("gain", "Stiffness"), "/control/kp_N_per_mm", "N/mm", 100, 200, 3},
      {"kd", QT_TRANSLATE_NOOP("gain", "Damping"), "/control/kd_N_s_per_mm", "N s/mm", 10000, 100, 5},
      {"ki", QT_TRANSLATE_NOOP("gain", "Integral"), "/control/ki_N_per_mm_s", "N/(mm s)", 100, 500, 3}};
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
