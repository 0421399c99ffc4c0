#include "app/gui/window/stop_banner.h"

#include <QAccessible>
#include <QEvent>

#include "app/gui/kit/message_label.h"
#include "app/gui/view/scene_view.h"

namespace underact::gui {

constexpr int kTop_px = 16;

StopBanner::StopBanner(SceneView& view) : QPushButton(tr("Force is off. Start (F5)"), &view), view_(view) {
  nameWidget(this, "view.stopped", text(), tr("The servo is stopped: nothing pushes. Press here or F5 to start it."));
  setProperty("role", "banner");
  setAutoDefault(false);
  setCursor(Qt::PointingHandCursor);
  hide();
  view_.installEventFilter(this);
  setTabOrder(&view_, this);  // otherwise last of all, since it is made last
}

void StopBanner::present(bool is_off) {
  if (is_off == !isHidden()) return;
  setVisible(is_off);
  if (!is_off) return;
  place();
  QAccessibleEvent alert(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

/// At the top, where a fault or a remark would be.
void StopBanner::place() {
  resize(sizeHint());
  move((view_.width() - width()) / 2, kTop_px);
  raise();
}

bool StopBanner::eventFilter(QObject* watched, QEvent* event) {
  const bool changes = event->type() == QEvent::Resize || event->type() == QEvent::FontChange;
  if (changes && !isHidden()) place();
  return QPushButton::eventFilter(watched, event);
}

}  // namespace underact::gui
