#pragma once
#include <QDockWidget>
#include <QMainWindow>
#include <map>
#include <string>

namespace underact::gui::test {

/// The docks that are seen, not hidden behind another tab, and how wide each is.
inline std::map<std::string, int> docksSeen(const QMainWindow& window) {
  std::map<std::string, int> seen;
  for (const QDockWidget* dock : window.findChildren<QDockWidget*>()) {
    const bool in_front = dock->isVisible() && window.rect().intersects(dock->geometry());
    if (in_front) seen[dock->objectName().toStdString()] = dock->width();
  }
  return seen;
}

}  // namespace underact::gui::test
