#pragma once
#include <QList>
#include <QWidget>
#include <cstdint>

#include "app/gui/feature/parts.h"
#include "app/gui/feature/servo_listener.h"

class QDockWidget;
class QMainWindow;

namespace underact::gui {

/// Interval, by the arm's clock, at which panels update numbers that change with every tick.
inline constexpr std::int64_t kBetweenNumbers_ns = 100'000'000;

/// A widget in a dock that shows or changes what the servo does.
class Panel : public QWidget, public ServoListener {
  Q_OBJECT
 public:
  using QWidget::QWidget;
  /// Opens its dock, in front of those that share its place.
  void bringForward();
  /// Neither hidden nor behind another tab (where Qt leaves it visible, outside the window). visibleRegion() does not
  /// tell: it is empty where opaque children cover the whole widget.
  bool isSeen() const;
};

/// A dock for the panel with that key, in its initial area.
QDockWidget* makeDock(const QString& key, const QString& title, Qt::DockWidgetArea home, QMainWindow* window);
/// The window's docks, in the order in which they were made.
QList<QDockWidget*> docksOf(const QMainWindow* window);
QString keyOf(const QDockWidget* dock);
Qt::DockWidgetArea homeOf(const QDockWidget* dock);

}  // namespace underact::gui
