#include "app/gui/window/docks.h"

#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QLineEdit>
#include <QMainWindow>
#include <algorithm>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/window/purpose.h"

namespace underact::gui {
namespace {

constexpr int kMinLines = 12, kMaxPercent = 20;          // of a panel's width
constexpr int kPlotsPercent = 25, kSessionPercent = 42;  // of the window's height

/// Plots below the view, which were closed, get enough of the window to be read.
void heighten(QDockWidget* dock) {
  auto* const window = qobject_cast<QMainWindow*>(dock->window());
  if (window == nullptr || homeOf(dock) != Qt::BottomDockWidgetArea || dock->isFloating()) return;
  const int min = window->height() * (dock->objectName() == "dock.session" ? kSessionPercent : kPlotsPercent) / 100;
  if (dock->height() < min) window->resizeDocks({dock}, {min}, Qt::Vertical);
}

QAction* addDockAction(Actions& actions, const PanelRow& row, QDockWidget* dock) {
  QAction* action = actions.add({dock->objectName(),
                                 dock->windowTitle(),
                                 QKeySequence(row.shortcut),
                                 QCoreApplication::translate("panel", row.tip),
                                 row.key,  // its icon
                                 {},
                                 true},
                                [dock](const QVariantList& on) {
                                  dock->setVisible(on.value(0).toBool());
                                  dock->raise();  // in front of the panels it shares its tabs with
                                  if (on.value(0).toBool()) heighten(dock);
                                  return true;
                                });
  // Checked: it is in front. One behind a tab comes forward when its button is pressed, and is not closed.
  QObject::connect(dock, &QDockWidget::visibilityChanged, action, [dock, action](bool is_front) {
    if (dock->window()->isVisible()) action->setChecked(is_front);
  });
  return action;
}

/// Sizes of the docks that exist.
void resize(QMainWindow* window, const QList<QPair<QDockWidget*, int>>& sizes, Qt::Orientation orientation) {
  QList<QDockWidget*> docks;
  QList<int> lengths;
  for (const auto& [dock, lines] : sizes) {
    if (dock == nullptr) continue;
    docks << dock;
    lengths << lines * window->fontMetrics().lineSpacing();
  }
  if (!docks.isEmpty()) window->resizeDocks(docks, lengths, orientation);
}

/// As wide as what is in it asks for, in the room there is.
void widen(QMainWindow* window, QDockWidget* dock) {
  if (dock == nullptr) return;
  const int max = std::max(kMinLines * window->fontMetrics().lineSpacing(), window->width() * kMaxPercent / 100);
  window->resizeDocks({dock}, {std::min(dock->widget()->sizeHint().width(), max)}, Qt::Horizontal);
}

}  // namespace

std::vector<PanelRow> panelsOf(const std::vector<FeatureRow>& rows) {
  std::vector<PanelRow> all;
  for (const FeatureRow& feature : rows) all.insert(all.end(), feature.panels.begin(), feature.panels.end());
  return all;
}

Docks::Docks(const std::vector<FeatureRow>& rows, const FeatureParts& parts)
    : window_(parts.window), rows_(panelsOf(rows)) {
  for (const PanelRow& row : rows_) {
    const QString title = QCoreApplication::translate("panel", row.title);
    QDockWidget* made = makeDock(row.key, title, row.area, window_);
    Panel* panel = row.make(parts, made);
    nameWidget(panel, QString("panel.%1").arg(row.key), title);
    made->setWidget(panel);
    addDockAction(parts.actions, row, made);
    docks_.insert(row.key, made);
    panels_.push_back(panel);
    if (row.behind == nullptr) continue;
    if (QDockWidget* front = dock(row.behind)) window_->tabifyDockWidget(front, made);
    made->hide();
  }
  for (QLineEdit* line : window_->findChildren<QLineEdit*>())
    line->setAcceptDrops(false);  // scenes are dropped on the window
}

void Docks::arrange(const Purpose& purpose) {
  for (const PanelRow& row : rows_) {
    QDockWidget* one = dock(row.key);
    one->setFloating(false);
    window_->addDockWidget(row.area, one);
    QDockWidget* front = row.behind == nullptr ? nullptr : dock(row.behind);
    if (front != nullptr) window_->tabifyDockWidget(front, one);
    one->setVisible(purpose.opened.contains(row.key));
  }
  resize(window_, {{dock("feel"), 18}}, Qt::Horizontal);
  widen(window_, dock("scenes"));
  resize(window_, {{dock("feel"), 26}, {dock("shape"), 9}, {dock("arm"), 10}}, Qt::Vertical);
  resize(window_, {{dock("plots"), 13}}, Qt::Vertical);
}

}  // namespace underact::gui
