#include "app/gui/feature/gain_row.h"

#include <QCoreApplication>

#include "app/gui/model/setting_words.h"

namespace underact::gui {
namespace {

constexpr double kLargest = 1e6;

QString translated(const char* text) {
  return QCoreApplication::translate("gain", text);
}

}  // namespace

const GainKind& gainKind(int gain) {
  static const GainKind kKinds[kGainKinds] = {
      {"kp", QT_TRANSLATE_NOOP("gain", "Stiffness"), "/control/kp_N_per_mm", 100, 200, 3},
      {"kd", QT_TRANSLATE_NOOP("gain", "Damping"), "/control/kd_N_s_per_mm", 10000, 100, 5},
      {"ki", QT_TRANSLATE_NOOP("gain", "Integral"), "/control/ki_N_per_mm_s", 100, 500, 3}};
  return kKinds[gain];
}

ValueKind gainValueKind(int gain) {
  const GainKind& is = gainKind(gain);
  return {settingTip(is.path), settingUnit(is.path), is.steps_per_unit, is.slider_steps, is.decimals, kLargest};
}

GainRow::GainRow(int gain, int axis, QWidget* parent)
    : ValueRow(gainValueKind(gain), QString("panel.gains.%1.%2").arg(gainKind(gain).key).arg(QChar('x' + axis)),
               parent),
      gain_(gainKind(gain)) {
  setAxisName(QChar('x' + axis));
}

void GainRow::setAxisName(const QString& axis) {
  setLabel(axis, QString("%1 %2").arg(translated(gain_.name), axis), "q1–q3");
}

}  // namespace underact::gui
