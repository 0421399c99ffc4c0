#include "app/gui/kit/tab_order.h"

#include <QFormLayout>
#include <QGridLayout>
#include <QScrollArea>
#include <algorithm>
#include <utility>
#include <vector>

namespace underact::gui {
namespace {

void collect(QWidget* widget, QList<QWidget*>& found);

/// The item's position: row, then column.
std::pair<int, int> placeOf(QLayout& layout, int index) {
  int row = 0, column = 0, rows = 0, columns = 0;
  if (auto* grid = qobject_cast<QGridLayout*>(&layout)) grid->getItemPosition(index, &row, &column, &rows, &columns);
  if (auto* form = qobject_cast<QFormLayout*>(&layout)) {
    QFormLayout::ItemRole role = QFormLayout::LabelRole;
    form->getItemPosition(index, &row, &role);
    column = role == QFormLayout::FieldRole ? 1 : 0;
  }
  return {row, column};
}

void collect(QLayout& layout, QList<QWidget*>& found) {
  std::vector<std::pair<std::pair<int, int>, QLayoutItem*>> items;
  for (int index = 0; index < layout.count(); ++index) items.push_back({placeOf(layout, index), layout.itemAt(index)});
  std::stable_sort(items.begin(), items.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [place, item] : items) {
    if (item->widget() != nullptr) collect(item->widget(), found);
    if (item->layout() != nullptr) collect(*item->layout(), found);
  }
}

void collect(QWidget* widget, QList<QWidget*>& found) {
  if (found.contains(widget)) return;
  found << widget;
  if (auto* scroll = qobject_cast<QScrollArea*>(widget); scroll != nullptr && scroll->widget() != nullptr)
    collect(scroll->widget(), found);
  if (widget->layout() != nullptr) collect(*widget->layout(), found);
  for (QObject* child : widget->children()) {
    auto* other = qobject_cast<QWidget*>(child);
    if (other != nullptr && !other->isWindow()) collect(other, found);
  }
}

}  // namespace

QList<QWidget*> readingOrder(QWidget* widget) {
  QList<QWidget*> found;
  collect(widget, found);
  return found;
}

void orderTabs(const QList<QWidget*>& groups) {
  QWidget* last = nullptr;
  for (QWidget* group : groups) {
    for (QWidget* widget : readingOrder(group)) {
      if ((widget->focusPolicy() & Qt::TabFocus) == 0 || widget->focusProxy() != nullptr) continue;
      if (last != nullptr) QWidget::setTabOrder(last, widget);
      last = widget;
    }
  }
}

}  // namespace underact::gui
