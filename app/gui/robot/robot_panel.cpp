#include "app/gui/robot/robot_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>
#include <cstdlib>

#include "app/gui/feature/setting_rows.h"
#include "app/gui/kit/chooser.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/panel_form.h"
#include "app/gui/kit/panel_scroll.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/value_row.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/document.h"
#include "app/gui/robot/robot_edits.h"
#include "app/gui/robot/sections.h"
#include "core/scene/compile.h"

namespace underact::gui {

RobotPanel::RobotPanel(const Parts& parts, QWidget* parent)
    : Panel(parent), parts_(parts), edits_(new RobotEdits(parts.document, this)), rows_(new SettingRows(this)) {
  build();
  connectParts();
  edits_->addCommands(parts_.actions);
  sceneOpened();
}

void RobotPanel::build() {
  auto* content = new QWidget;
  auto* inner = new QVBoxLayout(content);
  inner->setContentsMargins(8, 8, 8, 8);
  inner->setSpacing(4);
  none_ = new QLabel(tr("This scene has no virtual robot. “New robot” adds one with a single joint; the stylus is "
                        "pulled towards its end effector."),
                     content);
  none_->setObjectName("panel.robot.none");
  none_->setProperty("role", "quiet");
  none_->setWordWrap(true);
  inner->addWidget(none_);
  inner->addWidget(editor_ = makeEditor(content));
  inner->addStretch(1);
  // The read-out gets its rows with the first robot: reserve their width now.
  content->setMinimumWidth(fontMetrics().horizontalAdvance(tr("Moment, not sent") + tr("iteration, 100 of 100 steps")) +
                           48);
  QScrollArea* scroll = panelScroll(content, this);
  scroll->setMinimumWidth(std::max(content->minimumWidth(), content->minimumSizeHint().width()) + 16);
  auto* outer = tight<QVBoxLayout>(this, 0);
  outer->addWidget(scroll, 1);
  // Below the scroll area: the message is always visible, and moves nothing under the pointer when it appears.
  auto* foot = new QVBoxLayout;
  foot->setContentsMargins(8, 8, 8, 8);
  foot->setSpacing(8);
  refusal_ = messageLabel("panel.robot.refusal", tr("Why the change was refused"), "alarm", this);
  refusal_->hide();
  foot->addWidget(refusal_);
  new_ = pushButton("panel.robot.add", tr("New robot"), tr("Adds a robot with one joint to the scene."), this,
                    tr("Add a robot to the scene"));
  remove_ = pushButton("panel.robot.remove", tr("Remove robot"),
                       tr("Removes the robot shown from the scene; a scene needs at least one constraint."), this,
                       tr("Remove the robot shown from the scene"));
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(4);
  for (QPushButton* button : {new_, remove_}) buttons->addWidget(button);
  foot->addLayout(buttons);
  outer->addLayout(foot);
}

QWidget* RobotPanel::makeEditor(QWidget* parent) {
  auto* const made = new QWidget(parent);
  auto* column = tight<QVBoxLayout>(made, 4);
  choices_ = panelForm();
  chooser_ =
      chooser("panel.robot.constraint", tr("Robot shown"), tr("The robot of the scene that this panel shows."), this);
  choices_->addRow(tr("Robot"), chooser_);
  column->addLayout(choices_);
  column->addWidget(makePull(made));
  column->addWidget(chain_ = new ChainSection(made));
  column->addWidget(home_ = new HomeSection(made));
  column->addWidget(now_ = new RobotNowSection(made));
  column->addWidget(makeSolver(made));
  return made;
}

/// The force: rotational stiffness, the part of the stylus's orientation that is followed, force law.
QWidget* RobotPanel::makePull(QWidget* parent) {
  auto* const made = new Section("pull", tr("Force"),
                                 tr("The joints move to the minimum of the energy V = e·K e / 2, and the stylus is "
                                    "pulled towards the end effector: F = K e."),
                                 parent, "robot");
  const QString ko = tr("Kθ");
  ko_ = rows_->addNumber({"/ko_N_mm_per_rad", "panel.robot.ko", ko, tr("Rotational stiffness"), ko, 1, 500, 1, 1e6},
                         &made->column(), made);
  QFormLayout* const form = panelForm();
  made->column().addLayout(form);
  rows_->addChoice({"/orientation", "panel.robot.orientation", tr("Follows"),
                    tr("The part of the stylus's orientation that the end effector follows")},
                   form, made);
  rows_->addChoice({"/force_law", "panel.robot.law", tr("Force law"), tr("Force law")}, form, made);
  return made;
}

QWidget* RobotPanel::makeSolver(QWidget* parent) {
  auto* const made = new Section(
      "solver", tr("Solver"),
      tr("How the joint angles of minimum energy are found in every tick. The method does not change what you feel."),
      parent, "robot");
  QFormLayout* const form = panelForm();
  made->column().addLayout(form);
  rows_->addChoice({"/solver/method", "panel.robot.method", tr("Method"), tr("Method of the solver")}, form, made);
  rows_->addWhole(
      {"/solver/max_steps", "panel.robot.max_steps", tr("Max. steps"), tr("Maximum number of steps per tick")}, form,
      made);
  rows_->addText(
      {"/solver/tolerance", "panel.robot.tolerance", tr("Tolerance"), tr("Tolerance, rad and fractions of the reach")},
      form, made);
  return made;
}

void RobotPanel::connectParts() {
  connect(chooser_, &QComboBox::currentIndexChanged, edits_, &RobotEdits::choose);
  connect(new_, &QPushButton::clicked, edits_, &RobotEdits::addRobot);
  connect(remove_, &QPushButton::clicked, edits_, &RobotEdits::removeRobot);
  connect(rows_, &SettingRows::asked, edits_, &RobotEdits::set);
  connect(rows_, &SettingRows::refused, this, &RobotPanel::tell);
  connect(chain_, &ChainSection::typed, edits_, &RobotEdits::setJoint);
  connect(chain_, &ChainSection::addAsked, edits_, &RobotEdits::addJoint);
  connect(chain_, &ChainSection::removeAsked, edits_, &RobotEdits::removeJoint);
  connect(chain_, &ChainSection::moveAsked, edits_, &RobotEdits::moveJoint);
  connect(home_, &HomeSection::typed, edits_, &RobotEdits::setHome);
  connect(edits_, &RobotEdits::asked, this, &RobotPanel::tell);
  connect(edits_, &RobotEdits::chosen, this, &RobotPanel::refresh);
  connect(edits_, &RobotEdits::jointMoved, chain_, &ChainSection::select);
  connect(&parts_.document, &Document::opened, this, &RobotPanel::sceneOpened);
  connect(&parts_.document, &Document::edited, this, &RobotPanel::refresh);
}

void RobotPanel::sceneOpened() {
  edits_->reset();
  refusal_->hide();
  refresh();
}

void RobotPanel::listRobots() {
  const std::vector<std::size_t> robots = edits_->poll();
  const QSignalBlocker silent(chooser_);
  chooser_->clear();
  for (const std::size_t index : robots) {
    chooser_->addItem(QString::fromStdString(parts_.document.scene().constraints[index].name));
    if (index == edits_->index()) chooser_->setCurrentIndex(chooser_->count() - 1);
  }
  choices_->setRowVisible(chooser_, robots.size() > 1);
}

void RobotPanel::refresh() {
  listRobots();
  const scene::VirtualManipulator* shown = edits_->robot();
  editor_->setVisible(shown != nullptr);
  none_->setVisible(shown == nullptr);
  remove_->setEnabled(shown != nullptr && parts_.document.scene().constraints.size() > 1);
  new_->setEnabled(!parts_.document.scene().constraints.empty());
  if (shown == nullptr) return;
  rows_->present(parts_.document, edits_->index());
  ko_->setEnabled(shown->orientation != manipulator::Orientation::None);  // it would have no effect
  chain_->present(*shown);
  home_->present(shown->X_WV_home, edits_->angles_deg());
  const Result<tick::TickProgram> program = scene::compile(parts_.document.scene());
  if (program)
    now_->setRobot(std::get<manipulator::Manipulator>(program.value().entries[edits_->index()].constraint.goal),
                   program.value().needs.moment);
  shown_ns_ = -1;
}

void RobotPanel::present(const servo::Snapshot& snapshot) {
  if (edits_->robot() == nullptr || !isSeen()) return;
  if (snapshot.revision != parts_.servo.revision() || edits_->index() >= snapshot.report.held.size()) return;
  const std::int64_t now_ns = snapshot.report.sample.time_ns;
  if (shown_ns_ >= 0 && std::abs(now_ns - shown_ns_) < kBetweenNumbers_ns) return;
  shown_ns_ = now_ns;
  now_->present(snapshot.report.held[edits_->index()]);
}

void RobotPanel::tell(const Problems& problems) {
  refresh();  // if it was refused, shows the values in effect again
  showMessage(refusal_, sentencesOf(problems));
}

}  // namespace underact::gui
