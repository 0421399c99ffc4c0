#include "app/gui/kit/stop_key.h"

#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QLineEdit>

namespace underact::gui {
namespace {

/// The search field that has the focus and something in it, or null.
QLineEdit* filledSearch() {
  auto* const field = qobject_cast<QLineEdit*>(QApplication::focusWidget());
  const bool is_filled = field != nullptr && field->isClearButtonEnabled() && !field->text().isEmpty();
  return is_filled ? field : nullptr;
}

}  // namespace

StopKey::StopKey(std::function<void()> stop, std::function<bool()> always, QWidget* window)
    : QObject(window), stop_(std::move(stop)), always_(std::move(always)), window_(window) {
  QCoreApplication::instance()->installEventFilter(this);
}

StopKey::~StopKey() {
  QCoreApplication::instance()->removeEventFilter(this);
}

LeftByEsc* StopKey::openPart() const {
  if (QApplication::activeWindow() != window_) return nullptr;
  for (QWidget* widget : window_->findChildren<QWidget*>()) {
    auto* const part = dynamic_cast<LeftByEsc*>(widget);
    if (part != nullptr && part->isOpen()) return part;
  }
  return nullptr;
}

bool StopKey::isSomethingOnTop() const {
  if (QApplication::activePopupWidget() != nullptr) return true;
  const QWidget* const active =
      QApplication::activeModalWidget() != nullptr ? QApplication::activeModalWidget() : QApplication::activeWindow();
  if (qobject_cast<const QDialog*>(active) != nullptr) return !active->property(kEscStops).toBool();
  return filledSearch() != nullptr || openPart() != nullptr;
}

/// Closes what does not know Esc itself. Whether it did.
bool StopKey::press() {
  if (QApplication::activePopupWidget() != nullptr) return false;
  if (QLineEdit* const field = filledSearch()) {
    field->clear();
    return true;
  }
  if (qobject_cast<QDialog*>(QApplication::activeWindow()) != nullptr) return false;
  LeftByEsc* const part = openPart();
  if (part != nullptr) part->leaveByEsc();
  return part != nullptr;
}

bool StopKey::eventFilter(QObject*, QEvent* event) {
  // ShortcutOverride arrives first, at whatever has the focus, before any shortcut or widget can take the key.
  const bool comes_first = event->type() == QEvent::ShortcutOverride;
  if (!comes_first && event->type() != QEvent::KeyPress) return false;
  const auto* const key = static_cast<QKeyEvent*>(event);
  if (key->key() != Qt::Key_Escape) return false;
  if (key->modifiers().testFlag(Qt::ShiftModifier)) {
    stop_();
    return false;
  }
  const bool is_new = !closes_;
  closes_ = (closes_ && !comes_first) || isSomethingOnTop();
  if (!closes_ || always_()) stop_();
  if (!closes_) return false;
  // Until it has been delivered: a menu that it has closed is not on top any more when the window gets the key, too.
  if (is_new)
    QMetaObject::invokeMethod(
        this, [this] { closes_ = false; }, Qt::QueuedConnection);
  if (comes_first) {
    event->accept();  // as a key, not as the shortcut of Stop
    return true;
  }
  return press();
}

}  // namespace underact::gui
