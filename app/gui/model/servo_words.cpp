#include "app/gui/model/servo_words.h"

#include <QObject>

#include "app/gui/kit/words.h"

namespace underact::gui {

QString schedulingText(const system::Scheduling& scheduling) {
  const QString granted = sentenceText(scheduling.name);
  return scheduling.name == "normal" ? QObject::tr("real time: not granted")
                                     : QObject::tr("real time: %1").arg(granted);
}

}  // namespace underact::gui
