#include "app/gui/frames/transform_panel.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/arms/joint_fields.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/chooser.h"
#include "app/gui/kit/edit_table.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_table.h"
#include "app/gui/kit/panel_scroll.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/words.h"
#include "app/gui/view/drawing.h"
#include "app/gui/view/scene_view.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

using chain::Axes;
using chain::Step;
using chain::StepKind;

constexpr const char* kTransformOwner = "transform";
constexpr std::size_t kMaxSteps = 6;
constexpr double kMaxTurn_deg = 360.0, kMaxShift_mm = 200.0;  // the range of the view
constexpr double kSame_m = 5e-5, kSame_rad = 5e-4;            // not visible on the screen
constexpr const char* kTransformKeys[chain::kStepKinds] = {"Rx", "Ry", "Rz", "Dx", "Dy", "Dz"};

double stepUnit(StepKind kind) {
  return chain::isRotationStep(kind) ? 1.0 / kRadPerDegree : kMillimetrePerMetre;
}

void write(NumberTable& table, const Pose& X) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) table.set(row, column, numberText(X.linear()(row, column), 3));
    table.set(row, 3, numberText(kMillimetrePerMetre * X.translation()[row], 1));
  }
}

NumberTable* matrixTable(const QString& name, QWidget* parent) {
  auto* table = new NumberTable(
      name, {{"x", "−0.000"}, {"y", "−0.000"}, {"z", "−0.000"}, {TransformPanel::tr("p [mm]"), "−000.0"}}, parent);
  for (const char axis : {'x', 'y', 'z'})
    table->addRow(
        QString(QChar(axis)),
        TransformPanel::tr("Components along %1 of W of the frame's axes and of its position.").arg(QChar(axis)));
  return table;
}

/// "1 2 3" or "3 2 1"
QString orderOf(std::size_t count, bool reversed) {
  QStringList numbers;
  for (std::size_t step = 1; step <= count; ++step) numbers << QString::number(reversed ? count + 1 - step : step);
  return numbers.join(QChar(' '));
}

}  // namespace

TransformPanel::TransformPanel(const Parts& parts, QWidget* parent) : Panel(parent), parts_(parts) {
  build();
  addCommands();
  change({{{StepKind::TurnZ, kPi / 2}, {StepKind::TurnX, kPi / 2}, {StepKind::ShiftX, 0.04}}, Axes::Moving});
}

void TransformPanel::build() {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(8);
  axes_ = chooser("panel.transform.axes", tr("Axes that the steps refer to"),
                  tr("Moving: each step refers to the frame that results from the steps before it, X = S1 S2 S3. "
                     "Fixed: to the axes of W, X = S3 S2 S1. Craig, section 2.8."),
                  content);
  axes_->addItems({tr("About moving axes: X = S1 S2 …"), tr("About fixed axes: X = … S2 S1")});
  connect(axes_, &QComboBox::activated, this, [this](int index) { setAxes(index == 0 ? Axes::Moving : Axes::Fixed); });
  column->addWidget(axes_);
  table_ = new EditTable("panel.transform.steps", tr("Steps"), content);
  table_->setColumnCount(2);
  table_->setColumnHead(0, tr("step"), tr("R: rotation about an axis. D: translation along an axis."), "Rz  ");
  table_->setColumnHead(1, tr("value [° mm]"), tr("Angle in degrees, or distance in mm."), "−000.0");
  connect(table_, &EditTable::typed, this, [this](int row, int column_typed, const QString& text) {
    setStep(row, column_typed == 0 ? text : QString(), column_typed == 1 ? text : QString());
  });
  column->addWidget(table_);
  buildButtons(column);
  told_ = messageLabel("panel.transform.told", tr("Why the input was refused"), "warning", content);
  told_->hide();
  column->addWidget(told_);
  column->addWidget(sectionTitle(tr("As listed"), content));
  column->addWidget(listed_ = matrixTable("panel.transform.listed", content));
  column->addWidget(sectionTitle(tr("In reverse order"), content));
  column->addWidget(reversed_ = matrixTable("panel.transform.reversed", content));
  apart_ = messageLabel("panel.transform.apart", tr("Distance between the two results"), "", content);
  column->addWidget(apart_);
  column->addStretch(1);
  fillWithScroll(this, content);
}

void TransformPanel::buildButtons(QVBoxLayout* column) {
  buttons_.add = pushButton("panel.transform.add", tr("Add"), tr("Adds a step after the selected one; 6 at most."),
                            this, tr("Add a step"));
  buttons_.remove =
      pushButton("panel.transform.remove", tr("Remove"), tr("Removes the selected step; at least one remains."), this,
                 tr("Remove the selected step"));
  buttons_.undo = pushButton("panel.transform.undo", tr("Undo"), tr("Undoes the last change to the steps."), this,
                             tr("Undo the last change to the steps"));
  buttons_.redo = pushButton("panel.transform.redo", tr("Redo"), tr("Redoes the change that was undone."), this,
                             tr("Redo the change to the steps"));
  layEditRow(column, buttons_, parts_.actions, "transform");
}

void TransformPanel::addCommands() {
  Actions& actions = parts_.actions;
  actions.addCommand("transform.set", [this](const QVariantList& values) {  // step from 1, "Rx", 90
    return values.size() == 3 && setStep(values[0].toInt() - 1, values[1].toString(), values[2].toString());
  });
  actions.addCommand("transform.axes", [this](const QVariantList& values) {  // "moving" or "fixed"
    return setAxes(values.value(0).toString() == QLatin1String("fixed") ? Axes::Fixed : Axes::Moving);
  });
  actions.addCommand("transform.add", [this](const QVariantList&) {
    State state = states_.now();
    if (state.steps.size() >= kMaxSteps) return false;
    state.steps.insert(state.steps.begin() + selected() + 1, Step{StepKind::TurnZ, kPi / 4});
    return change(state);
  });
  actions.addCommand("transform.remove", [this](const QVariantList&) {
    State state = states_.now();
    if (state.steps.size() < 2) return false;
    state.steps.erase(state.steps.begin() + selected());
    return change(state);
  });
  addUndoCommands(actions, "transform", states_.stack(), [this] { refresh(); });
}

bool TransformPanel::setStep(int row, const QString& kind, const QString& amount) {
  State state = states_.now();
  if (row < 0 || row >= static_cast<int>(state.steps.size())) return false;
  Step& step = state.steps[static_cast<std::size_t>(row)];
  if (!kind.isEmpty()) {
    const auto* const found = std::find(std::begin(kTransformKeys), std::end(kTransformKeys), kind);
    if (found == std::end(kTransformKeys)) return false;
    const auto now = static_cast<StepKind>(found - std::begin(kTransformKeys));
    // The number on the screen stays, in its new unit.
    step = {now, step.amount * stepUnit(step.kind) / stepUnit(now)};
  }
  const Result<double> number =
      amount.isEmpty() ? Result<double>(step.amount * stepUnit(step.kind)) : typedNumber(amount);
  const double max = chain::isRotationStep(step.kind) ? kMaxTurn_deg : kMaxShift_mm;
  QString refused = number ? QString() : sentencesOf(number.problems());
  if (number && !(std::abs(number.value()) <= max))
    refused = chain::isRotationStep(step.kind)
                  ? tr("A rotation must be from −360 to 360 degrees.")
                  : tr("A translation must be from −200 to 200 mm, the range of the view.");
  showMessage(told_, refused);
  if (!refused.isEmpty()) return false;
  step.amount = number.value() / stepUnit(step.kind);
  return change(state);
}

bool TransformPanel::setAxes(Axes axes) {
  State state = states_.now();
  state.axes = axes;
  return change(state);
}

bool TransformPanel::change(const State& state) {
  states_.take(state);
  told_->hide();
  refresh();
  return true;
}

int TransformPanel::selected() const {
  return table_->currentRow() < 0 ? static_cast<int>(states_.now().steps.size()) - 1 : table_->currentRow();
}

std::vector<Pose> TransformPanel::frames(bool reversed) const {
  std::vector<Step> steps = states_.now().steps;
  if (reversed) std::reverse(steps.begin(), steps.end());
  std::vector<Pose> all = chain::composed(steps, states_.now().axes);
  all.insert(all.begin(), Pose::Identity());
  return all;
}

void TransformPanel::refresh() {
  const State& state = states_.now();
  {
    const QSignalBlocker silent(axes_);
    axes_->setCurrentIndex(state.axes == Axes::Moving ? 0 : 1);
  }
  const auto count = static_cast<int>(state.steps.size());
  if (table_->rowCount() != count) {
    const QSignalBlocker silent(table_);
    table_->setRowCount(count);
    for (int row = 0; row < count; ++row)
      table_->setVerticalHeaderItem(row, new QTableWidgetItem(QString::number(row + 1)));
    table_->fitHeight();
  }
  for (int row = 0; row < count; ++row) {
    const Step& step = state.steps[static_cast<std::size_t>(row)];
    const double amount = step.amount * stepUnit(step.kind);
    EditTable::Cell kind{kTransformKeys[static_cast<std::size_t>(step.kind)],
                         kTransformKeys[static_cast<std::size_t>(step.kind)], tr("step %1, kind").arg(row + 1),
                         tr("R: rotation about an axis. D: translation along an axis.")};
    for (const char* const key : kTransformKeys) kind.choices << key;
    table_->setCell(row, 0, kind);
    table_->setCell(row, 1,
                    {numberText(amount, 1), exactNumber(amount), tr("step %1, value").arg(row + 1),
                     chain::isRotationStep(step.kind) ? tr("Degrees.") : tr("Millimetres.")});
  }
  buttons_.add->setEnabled(state.steps.size() < kMaxSteps);
  buttons_.remove->setEnabled(state.steps.size() > 1);
  buttons_.undo->setEnabled(states_.stack().canUndo());
  buttons_.redo->setEnabled(states_.stack().canRedo());
  const Pose listed = frames(false).back(), reversed = frames(true).back();
  write(*listed_, listed);
  write(*reversed_, reversed);
  const double travel_m = (listed.translation() - reversed.translation()).norm();
  const double turn_rad = Eigen::AngleAxisd(listed.linear().transpose() * reversed.linear()).angle();
  apart_->setText(travel_m < kSame_m && turn_rad < kSame_rad
                      ? tr("Both orders end in the same pose: here, the order does not matter.")
                      : tr("The results are %1 and %2° apart: the order matters.")
                            .arg(millimetres(kMillimetrePerMetre * travel_m), numberText(turn_rad / kRadPerDegree, 1)));
  draw();
}

void TransformPanel::draw() {
  Drawing drawing;
  if (isSeen()) {
    const std::size_t count = states_.now().steps.size();
    for (const bool reversed : {false, true}) {
      const std::vector<Pose> all = frames(reversed);
      for (std::size_t step = 1; step < all.size(); ++step)
        drawing.links.push_back({all[step - 1].translation(), all[step].translation(), reversed});
      drawing.frames.push_back({all.back(), orderOf(count, reversed), 0.03});
    }
  }
  drawn_ = !drawing.isEmpty();
  parts_.view.draw(kTransformOwner, drawing);
}

void TransformPanel::present(const servo::Snapshot&) {
  if (isSeen() != drawn_) draw();
}

void TransformPanel::hideEvent(QHideEvent* event) {
  parts_.view.draw(kTransformOwner, {});
  drawn_ = false;
  Panel::hideEvent(event);
}

}  // namespace underact::gui
