#pragma once
#include <QList>

class QWidget;

namespace underact::gui {

/// A widget and all in it that its layouts hold, as the eye reads them: each layout by rows and from left to right.
/// What stands in no layout comes last; another window not at all.
QList<QWidget*> readingOrder(QWidget* widget);

/// The Tab key goes through these, one after the other, and through each in reading order.
void orderTabs(const QList<QWidget*>& groups);

}  // namespace underact::gui
