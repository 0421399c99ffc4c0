#include "app/gui/frames/dh_panel.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/chooser.h"
#include "app/gui/kit/edit_table.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_table.h"
#include "app/gui/kit/panel_scroll.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/document.h"
#include "app/gui/view/scene_view.h"
#include "core/base/units.h"
#include "core/chain/table_check.h"
#include "core/scene/scene_arm.h"

namespace underact::gui {
namespace {

constexpr const char* kDhOwner = "dh";
constexpr std::int64_t kBetween_ns = 100'000'000;  // of servo time: numbers that change faster cannot be read

}  // namespace

DhPanel::DhPanel(const Parts& parts, QWidget* parent) : Panel(parent), parts_(parts) {
  build();
  addCommands();
  start({});
  connect(&parts_.document, &Document::opened, this, &DhPanel::followScene);
  connect(&parts_.document, &Document::edited, this, &DhPanel::followScene);
}

void DhPanel::build() {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(8);
  start_ =
      chooser("panel.dh.start", tr("Table to start from"), tr("Replaces this table with that of an arm."), content);
  start_->addItem(tr("The scene's arm"), QString());
  for (const DhStart& one : dhStarts())
    start_->addItem(QCoreApplication::translate("explore", one.title), QString(one.key));
  for (const arm::Model& model : arm::models())
    start_->addItem(QString::fromStdString(model.title), QString::fromStdString(model.name));
  connect(start_, &QComboBox::activated, this, [this] { start(start_->currentData().toString()); });
  column->addWidget(start_);
  table_ = new EditTable("panel.dh.table", tr("DH table"), content);
  table_->setColumnCount(kDhFields);
  for (int field = 0; field < kDhFields; ++field) {
    const auto one = static_cast<DhField>(field);
    table_->setColumnHead(field, headOf(one), tipOf(one), one == DhField::Type ? tr("joint") : QString("−000.0"));
  }
  connect(table_, &EditTable::typed, this, &DhPanel::type);
  connect(table_, &QTableWidget::currentCellChanged, this, [this] { showTable(); });
  column->addWidget(table_);
  buildButtons(column);
  follows_ = new QCheckBox(tr("&Joints follow the arm"), content);
  nameWidget(follows_, "panel.dh.follow", tr("Joints follow the arm"),
             tr("Revolute joints 1 to 6 take the angles of the arm's joints: move the stylus, and the table follows."));
  follows_->setChecked(true);
  connect(follows_, &QCheckBox::toggled, this, &DhPanel::follow);
  column->addWidget(follows_);
  tip_ = new NumberTable("panel.dh.tip",
                         {{tr("x [mm]"), "−0000.0"}, {tr("y [mm]"), "−0000.0"}, {tr("z [mm]"), "−0000.0"}}, content);
  tip_->addRow(tr("Tip of the table"),
               tr("The position of the tip computed from the table, ⁰T₁ ¹T₂ …, in the workspace frame."));
  tip_->addRow(tr("Offset from arm"),
               tr("The vector from the tip of the arm to the tip of the table; 0 if the table is that of the arm."));
  column->addWidget(tip_);
  odd_ = messageLabel("panel.dh.odd", tr("Notes on the table"), "quiet", content);
  told_ = messageLabel("panel.dh.told", tr("Why the input was refused"), "warning", content);
  column->addWidget(odd_);
  column->addWidget(told_);
  column->addStretch(1);
  fillWithScroll(this, content);
}

void DhPanel::buildButtons(QVBoxLayout* column) {
  buttons_.add =
      pushButton("panel.dh.add", tr("Add"), tr("Adds a row after the selected one; 8 at most."), this, tr("Add a row"));
  buttons_.remove =
      pushButton("panel.dh.remove", tr("Remove"), tr("Removes the selected row; a table has at least one."), this,
                 tr("Remove the selected row"));
  buttons_.undo = pushButton("panel.dh.undo", tr("Undo"), tr("Undoes the last change to the table."), this,
                             tr("Undo the last change to the table"));
  buttons_.redo = pushButton("panel.dh.redo", tr("Redo"), tr("Redoes the change that was undone."), this,
                             tr("Redo the change to the table"));
  layEditRow(column, buttons_, parts_.actions, "dh");
}

void DhPanel::addCommands() {
  parts_.actions.addCommand("dh.start",
                            [this](const QVariantList& values) { return start(values.value(0).toString()); });
  parts_.actions.addCommand("dh.set", [this](const QVariantList& values) {  // row from 1, "alpha", "90"
    return values.size() == 3 && type(values[0].toInt() - 1, dhFieldOf(values[1].toString()), values[2].toString());
  });
  parts_.actions.addCommand("dh.add", [this](const QVariantList&) {
    return tables_.now().rows.size() < kMaxDhRows && change(withRow(tables_.now(), selected()));
  });
  parts_.actions.addCommand("dh.remove", [this](const QVariantList&) {
    return tables_.now().rows.size() > 1 && change(withoutRow(tables_.now(), selected()));
  });
  addUndoCommands(parts_.actions, "dh", tables_.stack(), [this] { showTable(); });
  parts_.actions.addCommand("dh.follow", [this](const QVariantList& values) {
    follows_->setChecked(values.value(0, true).toBool());
    return true;
  });
}

/// With another arm in the scene its table is shown, unless that of a certain arm was chosen.
void DhPanel::followScene() {
  const bool is_scenes = start_->currentData().toString().isEmpty();
  if (is_scenes && !(scene::armOf(parts_.document.scene()).geometry == of_scene_)) start({});
}

bool DhPanel::start(const QString& key) {
  if (const int index = start_->findData(key); index >= 0) start_->setCurrentIndex(index);
  if (key.isEmpty()) of_scene_ = scene::armOf(parts_.document.scene()).geometry;
  const auto starts = dhStarts();
  const auto* const textbook = std::find_if(starts.data(), starts.data() + starts.size(),
                                            [&](const DhStart& one) { return key == QLatin1String(one.key); });
  if (textbook != starts.data() + starts.size()) return change(textbook->make());
  const arm::Model* const model =
      key.isEmpty() ? &scene::modelOf(parts_.document.scene()) : arm::findModel(key.toStdString());
  return model != nullptr && change(tableOf(*model));
}

bool DhPanel::type(int row, int field, const QString& text) {
  if (row < 0 || field < 0) return false;
  const Result<DhTable> changed =
      withField(tables_.now(), static_cast<std::size_t>(row), static_cast<DhField>(field), text);
  if (changed) return change(changed.value());
  told_->setText(sentencesOf(changed.problems()));
  told_->show();
  return false;
}

bool DhPanel::change(const DhTable& table) {
  tables_.take(table);
  told_->hide();
  showTable();
  return true;
}

/// When they no longer follow, the joints stay where they are.
bool DhPanel::follow(bool on) {
  DhTable table = tables_.now();
  table.q = joints(true);
  if (!on) tables_.take(table);
  showTable();
  return true;
}

std::size_t DhPanel::selected() const {
  const int row = table_->currentRow();
  return row < 0 ? tables_.now().rows.size() - 1 : static_cast<std::size_t>(row);
}

std::vector<double> DhPanel::joints(bool follow) const {
  const DhTable& table = tables_.now();
  std::vector<double> q = table.q;
  for (std::size_t row = 0; follow && row < std::min(q.size(), q_rad_.size()); ++row) {
    if (table.rows[row].type == chain::JointType::Revolute) q[row] = q_rad_[row];
  }
  return q;
}

void DhPanel::showTable() {
  const DhTable& table = tables_.now();
  const auto count = static_cast<int>(table.rows.size());
  if (table_->rowCount() != count) {
    const QSignalBlocker silent(table_);
    table_->setRowCount(count);
    for (int row = 0; row < count; ++row)
      table_->setVerticalHeaderItem(row, new QTableWidgetItem(QString::number(row + 1)));
    table_->fitHeight();
  }
  showNumbers();
  buttons_.add->setEnabled(table.rows.size() < kMaxDhRows);
  buttons_.remove->setEnabled(table.rows.size() > 1);
  buttons_.undo->setEnabled(tables_.stack().canUndo());
  buttons_.redo->setEnabled(tables_.stack().canRedo());
  const Problems odd = chain::tableWarnings(table.rows);
  odd_->setText(sentencesOf(odd));
  odd_->setVisible(!odd.empty());
  draw();
}

void DhPanel::showNumbers() {
  DhTable now = tables_.now();
  now.q = joints(follows_->isChecked());
  for (int row = 0; row < table_->rowCount(); ++row) {
    for (int column = 0; column < kDhFields; ++column) {
      const auto field = static_cast<DhField>(column);
      const auto at = static_cast<std::size_t>(row);
      EditTable::Cell cell{shownText(now, at, field), exactText(now, at, field),
                           tr("row %1, %2").arg(row + 1).arg(headOf(field).simplified()), tipOf(field)};
      if (field == DhField::Type) cell.choices = QStringList{QObject::tr("revolute"), QObject::tr("prismatic")};
      const bool follows = follows_->isChecked() && at < q_rad_.size();
      if (field == DhField::Q) cell.editable = !(follows && now.rows[at].type == chain::JointType::Revolute);
      table_->setCell(row, column, cell);
    }
  }
  const Vec3 tip_mm = kMillimetrePerMetre * framesOf(now, now.q).back().translation();
  const Vec3 travel_mm = tip_mm - kMillimetrePerMetre * p_WT_;
  for (int axis = 0; axis < 3; ++axis) {
    tip_->set(0, axis, numberText(tip_mm[axis], 1));
    tip_->set(1, axis, numberText(travel_mm[axis], 1));
  }
}

void DhPanel::draw() {
  drawn_ = isSeen();
  Drawing drawing;
  if (drawn_) {
    const std::vector<double> q = joints(follows_->isChecked());
    drawing = drawingOf(tables_.now(), q);
    if (table_->currentRow() >= 0) drawing.measures = measuresOf(tables_.now(), q, selected());
  }
  parts_.view.draw(kDhOwner, drawing);
}

void DhPanel::present(const servo::Snapshot& snapshot) {
  const auto& sample = snapshot.report.sample;
  const bool known = std::all_of(sample.q_rad.begin(), sample.q_rad.end(), [](double q) { return std::isfinite(q); });
  if (!isSeen() && drawn_) draw();  // now behind another tab
  if (!isSeen() || !known) return;
  q_rad_ = sample.q_rad;
  p_WT_ = snapshot.report.p_WT;
  draw();
  if (shown_ns_ >= 0 && sample.time_ns >= shown_ns_ && sample.time_ns - shown_ns_ < kBetween_ns) return;
  shown_ns_ = sample.time_ns;
  if (table_->findChild<QWidget*>("panel.dh.table.editor") == nullptr) showNumbers();
}

void DhPanel::hideEvent(QHideEvent* event) {
  parts_.view.draw(kDhOwner, {});
  drawn_ = false;
  shown_ns_ = -1;
  Panel::hideEvent(event);
}

}  // namespace underact::gui
