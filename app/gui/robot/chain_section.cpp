#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/arms/joint_fields.h"
#include "app/gui/kit/edit_table.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/robot/sections.h"

namespace underact::gui {
namespace {

QPushButton* narrowButton(const char* name, const QString& text, const QString& spoken, const QString& tip,
                          QWidget* parent) {
  QPushButton* made = pushButton(name, text, tip, parent, spoken);
  made->setMinimumWidth(made->fontMetrics().horizontalAdvance(text) + 16);
  return made;
}

QString widestOf(JointField field) {
  if (field == JointField::Type) return QObject::tr("prismatic") + "  ";
  if (field >= JointField::AxisX && field <= JointField::AxisZ) return "−0.000";
  return field == JointField::Stiffness ? "000.00" : "−000.0";
}

}  // namespace

ChainSection::ChainSection(QWidget* parent)
    : Section("joints", tr("Joints"),
              tr("From the base to the end effector, in the home pose, in W: X = e^[S1] q1 … e^[Sn] qn X_home. Each "
                 "edited cell is one undo step."),
              parent, "robot"),
      table_(new EditTable("panel.robot.joints", tr("Joints of the robot"), this)),
      add_(narrowButton("panel.robot.joint.add", tr("Add"), tr("Add a joint after the selected one"),
                        tr("Adds a joint after the selected one; 8 at most."), this)),
      remove_(narrowButton("panel.robot.joint.remove", tr("Remove"), tr("Remove the selected joint"),
                           tr("Removes the selected joint; a robot has at least one."), this)),
      up_(narrowButton("panel.robot.joint.up", tr("Up"), tr("Move the selected joint towards the base"),
                       tr("Moves the selected joint towards the base."), this)),
      down_(narrowButton("panel.robot.joint.down", tr("Down"), tr("Move the selected joint towards the end effector"),
                         tr("Moves the selected joint towards the end effector."), this)) {
  table_->setColumnCount(kJointFields);
  for (int column = 0; column < kJointFields; ++column) {
    const auto field = static_cast<JointField>(column);
    table_->setColumnHead(column, headOf(field), tipOf(field), widestOf(field));
  }
  table_->horizontalHeaderItem(0)->setTextAlignment(Qt::AlignLeft | Qt::AlignBottom);
  column().addWidget(table_);
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  for (QPushButton* one : {add_, remove_, up_, down_}) row->addWidget(one);
  column().addLayout(row);
  connect(table_, &EditTable::typed, this, &ChainSection::typed);
  connect(table_, &QTableWidget::currentCellChanged, this, &ChainSection::showButtons);
  connect(add_, &QPushButton::clicked, this, [this] { emit addAsked(selected()); });
  connect(remove_, &QPushButton::clicked, this, [this] { emit removeAsked(selected()); });
  connect(up_, &QPushButton::clicked, this, [this] { emit moveAsked(selected(), -1); });
  connect(down_, &QPushButton::clicked, this, [this] { emit moveAsked(selected(), 1); });
}

int ChainSection::selected() const {
  return table_->currentRow() < 0 ? table_->rowCount() - 1 : table_->currentRow();
}

void ChainSection::select(int joint) {
  table_->setCurrentCell(joint, std::max(0, table_->currentColumn()));
}

void ChainSection::present(const scene::VirtualManipulator& robot) {
  const auto count = static_cast<int>(robot.joints.size());
  if (table_->rowCount() != count) {
    const QSignalBlocker silent(table_);
    table_->setRowCount(count);
    for (int row = 0; row < count; ++row) {
      table_->setVerticalHeaderItem(row, new QTableWidgetItem(QString("q%1").arg(row + 1)));
    }
    table_->fitHeight();
  }
  for (int row = 0; row < count; ++row) {
    const scene::Joint& joint = robot.joints[static_cast<std::size_t>(row)];
    for (int column = 0; column < kJointFields; ++column) {
      const auto field = static_cast<JointField>(column);
      EditTable::Cell cell{shownText(joint, field), exactText(joint, field),
                           tr("joint %1, %2").arg(row + 1).arg(headOf(field).simplified()), tipOf(field)};
      if (field == JointField::Type) cell.choices = QStringList{QObject::tr("revolute"), QObject::tr("prismatic")};
      cell.editable = isThere(joint, field);
      table_->setCell(row, column, cell);
    }
  }
  showButtons();
}

void ChainSection::showButtons() {
  const int count = table_->rowCount();
  add_->setEnabled(count < static_cast<int>(manipulator::kMaxJoints));
  remove_->setEnabled(count > 1);
  up_->setEnabled(selected() > 0);
  down_->setEnabled(selected() + 1 < count);
}

}  // namespace underact::gui
