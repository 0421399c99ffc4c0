#include "app/gui/model/limit_names.h"

#include <QCoreApplication>

namespace underact::gui {

using safety::Cuts;

std::span<const LimitName> limitNames() {
  static constexpr LimitName kNames[] = {
      {"clamp", QT_TRANSLATE_NOOP("limit", "Greatest force"), QT_TRANSLATE_NOOP("limit", "greatest force"),
       QT_TRANSLATE_NOOP("limit", "No force is greater than what the arm bears for good; its direction is kept."),
       safety::kClampBit, &Cuts::clamp_N},
      {"speed", QT_TRANSLATE_NOOP("limit", "Speed"), QT_TRANSLATE_NOOP("limit", "speed"),
       QT_TRANSLATE_NOOP("limit",
                         "From 1 m/s on less and from 2 m/s on none of the force may drive the stylus along; a force "
                         "that brakes it is not touched."),
       safety::kSpeedBit, &Cuts::speed_N},
      {"edge", QT_TRANSLATE_NOOP("limit", "Workspace edge"), QT_TRANSLATE_NOOP("limit", "edge"),
       QT_TRANSLATE_NOOP("limit", "In the last 3° before a joint's stop a force that presses towards it fades."),
       safety::kEdgeBit, &Cuts::edge_N},
      {"heat", QT_TRANSLATE_NOOP("limit", "Motor heat"), QT_TRANSLATE_NOOP("limit", "heat"),
       QT_TRANSLATE_NOOP("limit",
                         "From 90 % of the heat that a motor bears for good the force goes down to what it "
                         "can give for good."),
       safety::kHeatBit, &Cuts::heat_N},
      {"slew", QT_TRANSLATE_NOOP("limit", "Change of force"), QT_TRANSLATE_NOOP("limit", "change"),
       QT_TRANSLATE_NOOP("limit", "The force changes by 1 N in a millisecond at most."), safety::kSlewBit,
       &Cuts::slew_N},
      {"frozen", QT_TRANSLATE_NOOP("limit", "Frozen sample"), QT_TRANSLATE_NOOP("limit", "frozen sample"),
       QT_TRANSLATE_NOOP("limit",
                         "An arm whose joints stay the same to the last bit says nothing of the hand: the "
                         "force is let go until they move."),
       safety::kFrozenBit, nullptr},
  };
  return kNames;
}

QString mostLimiting(const Cuts& cuts) {
  const LimitName* most = nullptr;
  for (const LimitName& name : limitNames()) {
    if (name.cut_N == nullptr) {
      if (cuts.frozen) return QCoreApplication::translate("limit", name.word);
      continue;
    }
    const double cut_N = cuts.*name.cut_N;
    if (cut_N > 0.0 && (most == nullptr || cut_N > cuts.*most->cut_N)) most = &name;
  }
  return most == nullptr ? QString() : QCoreApplication::translate("limit", most->word);
}

}  // namespace underact::gui
