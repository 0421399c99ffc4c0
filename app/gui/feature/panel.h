#pragma once
#include <QList>
#include <QWidget>
#include <cstdint>

#include "app/gui/feature/follower.h"
#include "app/gui/feature/parts.h"

class QDockWidget;
class QMainWindow;

namespace underact::gui {

/// By the arm's clock, between two times that a panel writes numbers which change with every tick.
inline constexpr std::int64_t kBetweenNumbers_ns = 100'000'000;

/// A widget in a dock that shows what the servo does, or lets it be changed.
class Panel : public QWidget, public Follower {
  Q_OBJECT
 public:
  using QWidget::QWidget;
  /// Its dock is opened, and stands before those that share its place.
  void bringForward();
  /// Not hidden, nor behind another tab (where Qt leaves it visible, outside the window). visibleRegion() would not do:
  /// it is empty wherever opaque children cover all of a widget.
  bool isSeen() const;
};

/// A dock for the panel with that key, in the area where it stands at first.
QDockWidget* makeDock(const QString& key, const QString& title, Qt::DockWidgetArea home, QMainWindow* window);
/// Of the window, in the order in which they were made.
QList<QDockWidget*> docksOf(const QMainWindow* window);
QString keyOf(const QDockWidget* dock);
Qt::DockWidgetArea homeOf(const QDockWidget* dock);

}  // namespace underact::gui
