#include "app/gui/shape_panel.h"

#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/actions.h"
#include "app/gui/document.h"
#include "app/gui/panel_scroll.h"
#include "app/gui/readout.h"
#include "app/gui/shape_text.h"
#include "app/gui/words.h"
#include "core/base/units.h"
#include "core/scene/edit.h"

namespace underact::gui {
namespace {

QString heldText(const tick::Held& held) {
  switch (held.status) {
    case target::Status::Unique:
      return QObject::tr("%1 away").arg(millimetres(held.distance_m * kMillimetrePerMetre));
    case target::Status::Degenerate:
      return QObject::tr("equally far all around");
    case target::Status::Free:
      return QObject::tr("free");
  }
  return {};
}

}  // namespace

ShapePanel::ShapePanel(const PanelParts& parts, QWidget* parent)
    : Panel(parent), parts_(parts), readout_(new Readout("panel.shape.value")) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* content = new QWidget;
  auto* inner = new QVBoxLayout(content);
  inner->setContentsMargins(0, 0, 0, 0);
  inner->addWidget(readout_);
  edit_ = new QToolButton(this);
  edit_->setObjectName("panel.shape.edit_robot");
  edit_->setText(tr("Edit its joints"));
  edit_->setAccessibleName(edit_->text());
  edit_->setToolTip(tr("Opens the Robot panel: joints, springs, turning stiffness and solver."));
  edit_->setFocusPolicy(Qt::StrongFocus);
  connect(edit_, &QToolButton::clicked, this, [this] { parts_.actions.perform("dock.robot", true); });
  auto* line = new QHBoxLayout;
  line->setContentsMargins(12, 0, 12, 4);
  line->addWidget(edit_);
  line->addStretch(1);
  inner->addStretch(1);
  scroll_ = panelScroll(content, this);
  column->addWidget(scroll_, 1);
  column->addLayout(line);
  connect(&parts_.document, &Document::opened, this, &ShapePanel::sceneOpened);
  connect(&parts_.document, &Document::edited, this, &ShapePanel::sceneEdited);
  sceneOpened();
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
    const bool is_robot = std::holds_alternative<scene::VirtualManipulator>(constraint.shape);
    for (std::size_t index = 0; index < lines.size(); ++index) {
      readout_->set(readout_->addRow(lines[index].label), lines[index].value);
      if (is_robot && index == 0) addDistance();  // a robot has many lines: nobody should scroll for the distance
    }
    if (!is_robot) addDistance();
  }
  edit_->setVisible(std::any_of(constraints.begin(), constraints.end(), [](const scene::Constraint& one) {
    return std::holds_alternative<scene::VirtualManipulator>(one.shape);
  }));
  showOneShapeWhole();
}

void ShapePanel::addDistance() {
  distance_rows_.push_back(
      readout_->addRow(tr("Stylus"), tr("The distance e between the tip and the nearest point of the shape, or a "
                                        "robot's tip; free: a wall that is not touched.")));
}

void ShapePanel::showOneShapeWhole() {
  constexpr int kRows = 5;  // a circle's: with them nobody has to scroll for the distance
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
