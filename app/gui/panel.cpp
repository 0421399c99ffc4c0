#include "app/gui/panel.h"

#include <QDockWidget>

namespace underact::gui {

void Panel::bringForward() {
  auto* dock = qobject_cast<QDockWidget*>(parentWidget());
  if (dock == nullptr) return;
  dock->show();
  dock->raise();
}

bool Panel::isSeen() const {
  return isVisible() && window()->rect().intersects({mapTo(window(), QPoint()), size()});
}

}  // namespace underact::gui
