#include "tests/stories/held_paints.h"

#include <QCoreApplication>
#include <QEvent>
#include <algorithm>

namespace underact::gui::test {

HeldPaints::HeldPaints() {
  qApp->installEventFilter(this);
}

HeldPaints::~HeldPaints() {
  qApp->removeEventFilter(this);
  for (QObject* window : held_) {  // a window takes its request to be on its way, and sends no other
    if (window != nullptr) QCoreApplication::postEvent(window, new QEvent(QEvent::UpdateRequest), Qt::LowEventPriority);
  }
}

bool HeldPaints::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::UpdateRequest) return false;
  if (std::find(held_.begin(), held_.end(), watched) == held_.end()) held_.emplace_back(watched);
  return true;
}

}  // namespace underact::gui::test
