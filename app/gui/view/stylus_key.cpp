#include "app/gui/view/stylus_key.h"

#include <QApplication>
#include <QKeyEvent>
#include <QWidget>

#include "device/simulated_arm.h"

namespace underact::gui {

StylusKey::StylusKey(device::SimulatedArm& arm, QWidget* window, QWidget* view)
    : QObject(window), arm_(arm), window_(window), view_(view) {
  QCoreApplication::instance()->installEventFilter(this);
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
    if (now == nullptr || !isOurs(now)) hold(false);
  });
}

StylusKey::~StylusKey() {
  QCoreApplication::instance()->removeEventFilter(this);
  arm_.holdButton(false);
}

bool StylusKey::eventFilter(QObject* watched, QEvent* event) {
  const bool leaves = event->type() == QEvent::FocusOut || event->type() == QEvent::WindowDeactivate;
  if (leaves && (watched == view_ || watched == window_)) hold(false);
  if (event->type() != QEvent::KeyPress && event->type() != QEvent::KeyRelease) return false;
  const auto* key = static_cast<QKeyEvent*>(event);
  if (key->key() != Qt::Key_Space) return false;
  // A key release counts wherever it arrives: a menu may have opened in between.
  if (event->type() == QEvent::KeyRelease && !key->isAutoRepeat()) hold(false);
  const bool here = (watched == view_ || watched == window_) && isOurs(QApplication::focusWidget());
  if (!here) return false;
  if (event->type() == QEvent::KeyPress && !key->isAutoRepeat()) hold(true);
  return true;
}

void StylusKey::hold(bool held) {
  if (held == held_) return;
  held_ = held;
  arm_.holdButton(held);
}

}  // namespace underact::gui
