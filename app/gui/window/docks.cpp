#include "app/gui/window/docks.h"

#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QLineEdit>
#include <QMainWindow>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"

namespace underact::gui {
namespace {

QAction* addDockAction(Actions& actions, const PanelRow& row, QDockWidget* dock) {
  QAction* action = actions.add({dock->objectName(),
                                 dock->windowTitle(),
                                 QKeySequence(row.shortcut),
                                 QCoreApplication::translate("panel", row.tip),
                                 {},
                                 {},
                                 true},
                                [dock](const QVariantList& on) {
                                  dock->setVisible(on.value(0).toBool());
                                  dock->raise();  // in front of the panels it shares its tabs with
                                  return true;
                                });
  QObject::connect(dock, &QDockWidget::visibilityChanged, action,
                   [dock, action] { action->setChecked(!dock->isHidden()); });
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

void Docks::arrange() {
  for (const PanelRow& row : rows_) {
    QDockWidget* one = dock(row.key);
    one->setFloating(false);
    window_->addDockWidget(row.area, one);
    QDockWidget* front = row.behind == nullptr ? nullptr : dock(row.behind);
    if (front != nullptr) window_->tabifyDockWidget(front, one);
    one->setVisible(row.behind == nullptr);
  }
  resize(window_, {{dock("scenes"), 15}, {dock("feel"), 20}}, Qt::Horizontal);
  resize(window_, {{dock("feel"), 26}, {dock("shape"), 9}, {dock("arm"), 10}}, Qt::Vertical);
  resize(window_, {{dock("plots"), 13}}, Qt::Vertical);
}

}  // namespace underact::gui
