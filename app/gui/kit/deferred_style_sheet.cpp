#include "app/gui/kit/deferred_style_sheet.h"

#include <QChildEvent>
#include <QDockWidget>
#include <QWidget>

namespace underact::gui {

DeferredStyleSheet::DeferredStyleSheet(QWidget* window) : QObject(window), window_(window) {
  window_->installEventFilter(this);
}

void DeferredStyleSheet::set(const QString& sheet) {
  sheet_ = sheet;
  for (QWidget* child : window_->findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
    if (qobject_cast<QDockWidget*>(child) == nullptr) {
      give(*child);
      continue;
    }
    child->installEventFilter(this);
    const bool was_shown = !child->styleSheet().isEmpty();
    if (was_shown || !child->isHidden()) give(*child);
  }
}

bool DeferredStyleSheet::eventFilter(QObject* watched, QEvent* event) {
  if (watched == window_ && event->type() == QEvent::ChildPolished) {
    QObject* child = static_cast<QChildEvent*>(event)->child();  // created later, as dialogs are
    if (child->isWidgetType() && qobject_cast<QDockWidget*>(child) == nullptr) give(*static_cast<QWidget*>(child));
  }
  if (watched != window_ && event->type() == QEvent::Show) give(*static_cast<QWidget*>(watched));
  return QObject::eventFilter(watched, event);
}

void DeferredStyleSheet::give(QWidget& child) {
  if (child.styleSheet() != sheet_) child.setStyleSheet(sheet_);
}

}  // namespace underact::gui
