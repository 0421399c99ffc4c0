#include "app/gui/plot/column_button.h"

#include <QMenu>
#include <QSignalBlocker>

#include "app/gui/kit/message_label.h"
#include "app/gui/model/plot_columns.h"

namespace underact::gui {

ColumnButton::ColumnButton(const QString& name, QWidget* parent) : QToolButton(parent) {
  nameWidget(this, name, tr("Columns"), tr("Plots any columns of a session against time, up to six at once."));
  setText(tr("Columns"));
  setPopupMode(QToolButton::InstantPopup);
  setFocusPolicy(Qt::StrongFocus);
  auto* const menu = new QMenu(tr("Columns"), this);
  menu->setObjectName(name + ".menu");
  menu->setToolTipsVisible(true);
  for (const PlotColumn& column : plotColumns()) {
    QAction* const action =
        menu->addAction(column.unit.isEmpty() ? column.name : QString("%1 [%2]").arg(column.name, column.unit));
    action->setCheckable(true);
    action->setToolTip(column.meaning);
    connect(action, &QAction::toggled, this, &ColumnButton::read);
    actions_.push_back(action);
  }
  setMenu(menu);
}

void ColumnButton::read() {
  chosen_.clear();
  for (std::size_t index = 0; index < actions_.size(); ++index) {
    if (actions_[index]->isChecked()) chosen_.push_back(static_cast<int>(index));
  }
  const bool is_full = chosen_.size() >= kMax;
  for (QAction* const action : actions_) action->setEnabled(action->isChecked() || !is_full);
  setText(chosen_.empty() ? tr("Columns") : tr("Columns (%1)").arg(chosen_.size()));
  emit changed();
}

void ColumnButton::choose(const QStringList& names) {
  int count = 0;
  for (std::size_t index = 0; index < actions_.size(); ++index) {
    const QSignalBlocker silent(actions_[index]);
    const bool wanted = names.contains(plotColumns()[index].name) && count < kMax;
    count += wanted ? 1 : 0;
    actions_[index]->setChecked(wanted);
  }
  read();
}

QStringList ColumnButton::names() const {
  QStringList names;
  for (const int column : chosen_) names << plotColumns()[static_cast<std::size_t>(column)].name;
  return names;
}

}  // namespace underact::gui
