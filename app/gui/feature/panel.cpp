#include "app/gui/feature/panel.h"

#include <QDockWidget>

#include "app/gui/kit/message_label.h"

namespace underact::gui {
namespace {

const QString kDock = QStringLiteral("dock.");
constexpr const char* kHome = "home";

}  // namespace

void Panel::bringForward() {
  auto* dock = qobject_cast<QDockWidget*>(parentWidget());
  if (dock == nullptr) return;
  dock->show();
  dock->raise();
}

bool Panel::isSeen() const {
  return isVisible() && window()->rect().intersects({mapTo(window(), QPoint()), size()});
}

QDockWidget* makeDock(const QString& key, const QString& title, Qt::DockWidgetArea home, QMainWindow* window) {
  auto* dock = new QDockWidget(title, window);
  nameWidget(dock, kDock + key, title);
  dock->setProperty(kHome, home);
  window->addDockWidget(home, dock);
  return dock;
}

QList<QDockWidget*> docksOf(const QMainWindow* window) {
  return window->findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly);
}

QString keyOf(const QDockWidget* dock) {
  return dock->objectName().mid(static_cast<int>(kDock.size()));
}

Qt::DockWidgetArea homeOf(const QDockWidget* dock) {
  return static_cast<Qt::DockWidgetArea>(dock->property(kHome).toInt());
}

}  // namespace underact::gui
