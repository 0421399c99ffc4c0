#include "app/gui/kit/stop_key.h"

#include <QCoreApplication>
#include <QKeyEvent>

namespace underact::gui {

StopKey::StopKey(std::function<void()> stop, QObject* parent) : QObject(parent), stop_(std::move(stop)) {
  QCoreApplication::instance()->installEventFilter(this);
}

StopKey::~StopKey() {
  QCoreApplication::instance()->removeEventFilter(this);
}

bool StopKey::eventFilter(QObject*, QEvent* event) {
  // ShortcutOverride arrives first, at whatever has the focus, before any shortcut or widget can take the key.
  const bool key = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  if (key && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) stop_();
  return false;
}

}  // namespace underact::gui
