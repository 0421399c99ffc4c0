#include "app/gui/window/narrow_bar.h"

#include <QEvent>
#include <QLayout>
#include <QToolBar>
#include <QToolButton>

namespace underact::gui {

NarrowBar::NarrowBar(QToolBar* bar, QStringList buttons) : QObject(bar), bar_(bar), buttons_(std::move(buttons)) {
  bar_->installEventFilter(this);
}

bool NarrowBar::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::StyleChange || event->type() == QEvent::FontChange)
    QMetaObject::invokeMethod(
        this, [this] { fit(); }, Qt::QueuedConnection);
  return QObject::eventFilter(watched, event);
}

void NarrowBar::fit() {
  int room = bar_->width();
  int wanted = bar_->layout()->contentsMargins().left() + bar_->layout()->contentsMargins().right();
  for (QAction* action : bar_->actions()) {
    const QWidget* const widget = bar_->widgetForAction(action);
    wanted += bar_->layout()->spacing() +
              (widget == nullptr ? 0 : widget->sizeHint().expandedTo(widget->minimumSize()).width());
  }
  for (const QString& name : buttons_) {
    auto* const button = bar_->findChild<QToolButton*>(name);
    if (button == nullptr) continue;
    const QSize now = button->sizeHint();
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    wanted += button->sizeHint().width() - now.width();  // with its words
  }
  for (const QString& name : buttons_) {
    if (wanted <= room) return;
    auto* const button = bar_->findChild<QToolButton*>(name);
    if (button == nullptr) continue;
    const int before = button->sizeHint().width();
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    wanted -= before - button->sizeHint().width();
  }
}

}  // namespace underact::gui
