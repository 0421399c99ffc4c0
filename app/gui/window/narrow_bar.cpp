#include "app/gui/window/narrow_bar.h"

#include <QEvent>
#include <QLayout>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
#include <utility>

namespace underact::gui {

constexpr const char* kWords = "widthWithWords";  // that a button keeps, whatever its words are now
constexpr int kMargins_px = 16;                   // beside the words of a button in a bar along a side

NarrowBar::NarrowBar(QToolBar* bar, QStringList buttons) : QObject(bar), bar_(bar), buttons_(std::move(buttons)) {
  bar_->installEventFilter(this);
  for (const QString& name : buttons_) {
    auto* const button = bar_->findChild<QToolButton*>(name);
    if (button != nullptr) button->setProperty(kWords, button->minimumWidth());
  }
}

NarrowBar::NarrowBar(QToolBar* bar, int words_from_px) : QObject(bar), bar_(bar), words_from_px_(words_from_px) {
  bar_->window()->installEventFilter(this);  // the bar's own width follows from its words
  fitBeside();
}

bool NarrowBar::eventFilter(QObject* watched, QEvent* event) {
  if (words_from_px_ > 0) {
    if (event->type() == QEvent::Resize) fitBeside();
  } else if (event->type() == QEvent::Resize || event->type() == QEvent::StyleChange ||
             event->type() == QEvent::FontChange) {
    QMetaObject::invokeMethod(
        this, [this] { fitAlong(); }, Qt::QueuedConnection);
  }
  return QObject::eventFilter(watched, event);
}

void NarrowBar::fitBeside() {
  const bool has_words = bar_->window()->width() >= words_from_px_;
  const Qt::ToolButtonStyle wanted = has_words ? Qt::ToolButtonTextUnderIcon : Qt::ToolButtonIconOnly;
  if (std::exchange(is_fitted_, true) && bar_->toolButtonStyle() == wanted) return;
  bar_->setToolButtonStyle(wanted);
  int width = 0;
  for (const QAction* action : bar_->actions())
    width = std::max(width, bar_->fontMetrics().horizontalAdvance(action->iconText()) + kMargins_px);
  for (QAction* action : bar_->actions()) bar_->widgetForAction(action)->setMinimumWidth(has_words ? width : 0);
}

void NarrowBar::fitAlong() {
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
    const int now = std::max(button->sizeHint().width(), button->minimumWidth());
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setMinimumWidth(button->property(kWords).toInt());
    wanted += std::max(button->sizeHint().width(), button->minimumWidth()) - now;  // with its words
  }
  for (const QString& name : buttons_) {
    if (wanted <= room) return;
    auto* const button = bar_->findChild<QToolButton*>(name);
    if (button == nullptr) continue;
    const int before = std::max(button->sizeHint().width(), button->minimumWidth());
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setMinimumWidth(0);
    wanted -= before - button->sizeHint().width();
  }
}

}  // namespace underact::gui
