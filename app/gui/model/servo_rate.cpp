#include "app/gui/model/servo_rate.h"

#include "app/gui/kit/words.h"

namespace underact::gui {

Problems ServoRate::tryOut(int rate_hz) {
  const int was_hz = hz();
  Problems problems = host_.setRate(rate_hz);
  if (problems.empty() && was_hz != rate_hz) emit changed(was_hz, rate_hz);
  return problems;
}

Problems ServoRate::choose(int rate_hz) {
  Problems problems = tryOut(rate_hz);
  if (problems.empty()) chosen_ = rate_hz;
  return problems;
}

QString schedulingText(const system::Scheduling& scheduling) {
  const QString granted = sentenceText(scheduling.name);
  return scheduling.name == "normal" ? QObject::tr("real time: not granted")
                                     : QObject::tr("real time: %1").arg(granted);
}

}  // namespace underact::gui
