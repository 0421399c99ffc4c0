// Of access_desk.h: the way of the Tab key.
#include <QAbstractScrollArea>
#include <QApplication>
#include <algorithm>

#include "tests/stories/access_desk.h"

namespace underact::gui::test {
namespace {

QRect placeOf(const QWidget& widget) {
  return {widget.mapTo(widget.window(), QPoint()), widget.size()};
}

/// Whether the eye comes to b before a: it stands higher, or in the same row further to the left.
bool isBefore(const QWidget& b, const QWidget& a) {
  const QRect there = placeOf(b), here = placeOf(a);
  const int shared = std::min(there.bottom(), here.bottom()) - std::max(there.top(), here.top());
  const bool one_row = 2 * shared > std::min(there.height(), here.height());
  return one_row ? there.right() <= here.left() : there.bottom() <= here.top();
}

/// Out of what it scrolls in; of a widget larger than that, some of it is enough.
bool isSeen(const QWidget& widget) {
  const auto* const area = qobject_cast<const QAbstractScrollArea*>(&widget);  // what it shows may cover all of it
  return !widget.visibleRegion().isEmpty() || (area != nullptr && !area->viewport()->visibleRegion().isEmpty());
}

constexpr int kMaxStops = 400;

/// The stops from `from` on until the focus leaves the widget, or has gone round a window; each once, though links in a
/// text are stops of their own.
QList<QWidget*> stops(Story& story, QWidget& root, QWidget* from, Qt::Key key, QStringList& wrong) {
  QList<QWidget*> met;
  QWidget* here = from;
  const bool is_alone = reachable(root).size() == 1;
  for (int step = 0; step < kMaxStops; ++step) {
    if (met.isEmpty() || met.last() != here) met << here;
    if (!isSeen(*here)) wrong << idOf(here) + " has the focus where it cannot be seen";
    story.key(key);
    here = QApplication::focusWidget();
    if (here == nullptr || (here != &root && !root.isAncestorOf(here)) ||
        (here == from && (met.size() > 1 || is_alone)))
      return met;
  }
  wrong << idOf(met.last()) + " does not let the focus go";
  return met;
}

QStringList differences(const QList<QWidget*>& wanted, const QList<QWidget*>& met, const QString& context) {
  QStringList wrong;
  for (QWidget* widget : wanted)
    if (!met.contains(widget) && widget->isEnabled() && widget->isVisible())
      wrong << idOf(widget) + " is left out by " + context;
  for (QWidget* widget : met)
    if (met.count(widget) > 1) wrong << idOf(widget) + " comes more than once by " + context;
  return wrong;
}

}  // namespace

QStringList wronglyOrdered(Story& story, QWidget& root) {
  const QList<QWidget*> wanted = reachable(root);
  if (wanted.isEmpty()) return {};
  QStringList wrong;
  QWidget* first = *std::min_element(wanted.begin(), wanted.end(), [](const QWidget* a, const QWidget* b) {
    return std::pair(placeOf(*a).top(), placeOf(*a).left()) < std::pair(placeOf(*b).top(), placeOf(*b).left());
  });
  first->setFocus(Qt::TabFocusReason);
  if (!root.isWindow()) {  // what Shift+Tab leaves it from is the first, wherever it stands
    const QList<QWidget*> back = stops(story, root, first, Qt::Key_Backtab, wrong);
    first = back.last();
    first->setFocus(Qt::TabFocusReason);
  }
  const QList<QWidget*> on = stops(story, root, first, Qt::Key_Tab, wrong);
  wrong << differences(wanted, on, "Tab");
  for (int stop = 1; stop < on.size(); ++stop) {
    if (isBefore(*on[stop], *on[stop - 1])) wrong << idOf(on[stop]) + " comes after " + idOf(on[stop - 1]);
  }
  on.last()->setFocus(Qt::BacktabFocusReason);
  wrong << differences(wanted, stops(story, root, on.last(), Qt::Key_Backtab, wrong), "Shift+Tab");
  wrong.removeDuplicates();
  return wrong;
}

}  // namespace underact::gui::test
