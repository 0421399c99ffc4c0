#include "app/gui/model/limit_names.h"

#include <QCoreApplication>

namespace underact::gui {

using safety::Cuts;

std::span<const LimitName> limitNames() {
  static constexpr LimitName kNames[] = {
      {"clamp", QT_TRANSLATE_NOOP("limit", "Maximum force"), QT_TRANSLATE_NOOP("limit", "maximum force"),
       QT_TRANSLATE_NOOP("limit", "Limits the force to the arm's continuous force; its direction is kept."),
       safety::kClampBit, &Cuts::clamp_N},
      {"speed", QT_TRANSLATE_NOOP("limit", "Speed"), QT_TRANSLATE_NOOP("limit", "speed"),
       QT_TRANSLATE_NOOP("limit",
                         "Above 1 m/s, force in the direction of motion is reduced; from 2 m/s it is zero. Force "
                         "against the motion is not limited."),
       safety::kSpeedBit, &Cuts::speed_N},
      {"motors", QT_TRANSLATE_NOOP("limit", "Motors"), QT_TRANSLATE_NOOP("limit", "motors"),
       QT_TRANSLATE_NOOP("limit",
                         "Removes what no motor can render: a joint without a motor passes no torque on, and no joint "
                         "moves the tip in some directions. Zero for haptic arms such as the Omni."),
       safety::kMotorsBit, &Cuts::motors_N},
      {"edge", QT_TRANSLATE_NOOP("limit", "Workspace edge"), QT_TRANSLATE_NOOP("limit", "edge"),
       QT_TRANSLATE_NOOP("limit", "Within 3° of a joint's stop, a force that presses towards it fades out."),
       safety::kEdgeBit, &Cuts::edge_N},
      {"heat", QT_TRANSLATE_NOOP("limit", "Motor heat"), QT_TRANSLATE_NOOP("limit", "heat"),
       QT_TRANSLATE_NOOP(
           "limit",
           "Between 90 % and 100 % of a motor's permissible heat, the force is reduced to its continuous force."),
       safety::kHeatBit, &Cuts::heat_N},
      {"slew", QT_TRANSLATE_NOOP("limit", "Slew rate"), QT_TRANSLATE_NOOP("limit", "slew rate"),
       QT_TRANSLATE_NOOP("limit", "The force changes by at most 1 N per millisecond."), safety::kSlewBit,
       &Cuts::slew_N},
      {"frozen", QT_TRANSLATE_NOOP("limit", "Frozen sample"), QT_TRANSLATE_NOOP("limit", "frozen sample"),
       QT_TRANSLATE_NOOP("limit",
                         "If the joint angles stay identical to the last bit for some time, the arm no longer measures "
                         "the hand: the force fades out until they change."),
       safety::kFrozenBit, nullptr},
  };
  return kNames;
}

QString mostLimiting(const Cuts& cuts) {
  const LimitName* max = nullptr;
  for (const LimitName& name : limitNames()) {
    if (name.cut_N == nullptr) {
      if (cuts.frozen) return QCoreApplication::translate("limit", name.word);
      continue;
    }
    const double cut_N = cuts.*name.cut_N;
    if (cut_N > 0.0 && (max == nullptr || cut_N > cuts.*max->cut_N)) max = &name;
  }
  return max == nullptr ? QString() : QCoreApplication::translate("limit", max->word);
}

}  // namespace underact::gui
