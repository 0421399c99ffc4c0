#pragma once
#include <QList>

class QWidget;

namespace underact::gui {

/// A widget and everything in its layouts in reading order: each layout by rows, from left to right. Widgets in no
/// layout come last; other windows are excluded.
QList<QWidget*> readingOrder(QWidget* widget);

/// Sets the Tab order: these widgets one after the other, each in reading order.
void orderTabs(const QList<QWidget*>& groups);

}  // namespace underact::gui
