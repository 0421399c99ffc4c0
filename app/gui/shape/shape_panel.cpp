#include "app/gui/shape/shape_panel.h"

#include <QMenu>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/panel_scroll.h"
#include "app/gui/kit/readout.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/document.h"
#include "app/gui/shape/shape_text.h"
#include "core/base/units.h"
#include "core/scene/edit.h"

namespace underact::gui {
namespace {

QString heldText(const tick::ConstraintReport& held) {
  switch (held.status) {
    case target::Status::Unique:
      return QObject::tr("%1 away").arg(millimetres(held.distance_m * kMillimetrePerMetre));
    case target::Status::Degenerate:
      return QObject::tr("equidistant");
    case target::Status::Free:
      return QObject::tr("free");
  }
  return {};
}

}  // namespace

ShapePanel::ShapePanel(const Parts& parts, QWidget* parent)
    : Panel(parent), parts_(parts), readout_(new Readout("panel.shape.value")) {
  auto* column = tight<QVBoxLayout>(this);
  auto* content = new QWidget;
  auto* inner = tight<QVBoxLayout>(content);
  inner->addWidget(readout_);
  edit_ = addButton("panel.shape.edit_robot", tr("Edit joints"),
                    tr("Opens the Robot panel: joints, springs, rotational stiffness and solver."));
  report_ = addButton("panel.shape.report", tr("Report…"),
                      tr("What the mesh file contains, what was repaired, and how the mesh can be felt."));
  report_->setPopupMode(QToolButton::InstantPopup);
  reports_ = new QMenu(report_);
  connect(report_, &QToolButton::clicked, this, [this] {
    if (report_->menu() == nullptr) parts_.actions.perform("mesh.report");
  });
  connect(edit_, &QToolButton::clicked, this, [this] { parts_.actions.perform("dock.robot", true); });
  auto* line = new QHBoxLayout;
  line->setContentsMargins(12, 0, 12, 4);
  line->addWidget(edit_);
  line->addWidget(report_);
  line->addStretch(1);
  inner->addStretch(1);
  scroll_ = panelScroll(content, this);
  column->addWidget(scroll_, 1);
  column->addLayout(line);
  connect(&parts_.document, &Document::opened, this, &ShapePanel::sceneOpened);
  connect(&parts_.document, &Document::edited, this, &ShapePanel::sceneEdited);
  sceneOpened();
}

QToolButton* ShapePanel::addButton(const char* name, const QString& text, const QString& tip) {
  auto* made = new QToolButton(this);
  made->setObjectName(name);
  made->setText(text);
  made->setAccessibleName(text);
  made->setToolTip(tip);
  made->setFocusPolicy(Qt::StrongFocus);
  return made;
}

void ShapePanel::offerReports() {
  const std::vector<scene::Constraint>& constraints = shown_.constraints;
  reports_->clear();
  for (std::size_t index = 0; index < constraints.size(); ++index) {
    if (!std::holds_alternative<scene::Mesh>(constraints[index].shape)) continue;
    const auto ask = [this, index] { parts_.actions.perform("mesh.report", QVariant::fromValue(index)); };
    connect(reports_->addAction(menuText(QString::fromStdString(constraints[index].name))), &QAction::triggered, this,
            ask);
  }
  const auto count = reports_->actions().size();
  report_->setMenu(count > 1 ? reports_ : nullptr);  // with one mesh there is nothing to choose
  report_->setVisible(count > 0);
}

void ShapePanel::sceneEdited() {
  if (scene::changeBetween(shown_, parts_.document.scene()) != scene::Change::Gains) sceneOpened();
}

void ShapePanel::sceneOpened() {
  shown_ = parts_.document.scene();
  readout_->clear();
  distance_rows_.clear();
  const std::vector<scene::Constraint>& constraints = parts_.document.scene().constraints;
  for (const scene::Constraint& constraint : constraints) {
    if (constraints.size() > 1) readout_->addHeading(QString::fromStdString(constraint.name));
    const std::vector<ShapeLine> lines = shapeText(constraint);
    const bool has_many_lines = std::holds_alternative<scene::VirtualManipulator>(constraint.shape) ||
                                std::holds_alternative<scene::Mesh>(constraint.shape) ||
                                std::holds_alternative<scene::Curve>(constraint.shape);
    for (std::size_t index = 0; index < lines.size(); ++index) {
      readout_->set(readout_->addRow(lines[index].label), lines[index].value);
      if (has_many_lines && index == 0) addDistance();  // visible without scrolling
    }
    if (!has_many_lines) addDistance();
  }
  edit_->setVisible(std::any_of(constraints.begin(), constraints.end(), [](const scene::Constraint& one) {
    return std::holds_alternative<scene::VirtualManipulator>(one.shape);
  }));
  offerReports();
  showShapeFully();
}

void ShapePanel::addDistance() {
  distance_rows_.push_back(
      readout_->addRow(tr("Stylus"), tr("Distance e from the tip to the nearest point of the shape, or to the end "
                                        "effector of a robot. Free: the tip does not touch the wall.")));
}

void ShapePanel::showShapeFully() {
  constexpr int kRows = 5;  // as many as a circle has, so that the distance is visible without scrolling
  const int row = fontMetrics().lineSpacing() + 4;
  scroll_->setMinimumHeight(std::min(readout_->sizeHint().height(), kRows * row + 16));
}

void ShapePanel::present(const servo::Snapshot& snapshot) {
  const std::size_t shown = std::min(distance_rows_.size(), snapshot.report.held.size());
  for (std::size_t index = 0; index < shown; ++index) {
    readout_->set(distance_rows_[index], heldText(snapshot.report.held[index]));
  }
}

}  // namespace underact::gui
