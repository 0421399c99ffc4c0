#pragma once
#include <QAccessible>

class QWidget;

namespace underact::gui {

/// Tells screen readers what Qt leaves out: the text of a label that has an accessible name ("Force: force 0.31 / 0.88
/// N"), also when it changes, at most twice a second; and that charts, bars and the view are graphics, not empty panes.
/// Called once; widgets need no changes. Costs nothing without a screen reader.
void makeWidgetsAccessible();

/// Declares that a widget which paints itself is a chart, a graphic or a canvas. Call it before the widget is read.
void setAccessibleRole(QWidget* widget, QAccessible::Role role);

}  // namespace underact::gui
