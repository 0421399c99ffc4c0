// How the Robot panel is put together; what it does is in robot_panel.cpp.
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/kit/chooser.h"
#include "app/gui/kit/panel_scroll.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/robot/robot_panel.h"
#include "app/gui/robot/sections.h"

namespace underact::gui {

void RobotPanel::build() {
  auto* content = new QWidget;
  auto* inner = new QVBoxLayout(content);
  inner->setContentsMargins(8, 8, 8, 8);
  inner->setSpacing(4);
  none_ =
      new QLabel(tr("This scene has no virtual robot. A new one is added beside what there is: one joint, whose tip "
                    "the stylus is drawn to."),
                 content);
  none_->setObjectName("panel.robot.none");
  none_->setProperty("role", "quiet");
  none_->setWordWrap(true);
  inner->addWidget(none_);
  editor_ = new QWidget(content);
  auto* column = new QVBoxLayout(editor_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  choices_ = new QFormLayout;
  choices_->setHorizontalSpacing(12);
  choices_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  chooser_ =
      chooser("panel.robot.constraint", tr("Robot that is shown"), tr("Which robot of the scene is shown."), this);
  choices_->addRow(tr("Robot"), chooser_);
  column->addLayout(choices_);
  column->addWidget(pull_ = new PullSection(editor_));
  column->addWidget(chain_ = new ChainSection(editor_));
  column->addWidget(home_ = new HomeSection(editor_));
  column->addWidget(now_ = new RobotNowSection(editor_));
  column->addWidget(solver_ = new SolverSection(editor_));
  inner->addWidget(editor_);
  inner->addStretch(1);
  // The read-out fills in its rows with the first robot: what they need is known before.
  content->setMinimumWidth(fontMetrics().horizontalAdvance(tr("Moment, not sent") + tr("iteration, 100 of 100 steps")) +
                           48);
  QScrollArea* scroll = panelScroll(content, this);
  scroll->setMinimumWidth(std::max(content->minimumWidth(), content->minimumSizeHint().width()) + 16);
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->setSpacing(0);
  outer->addWidget(scroll, 1);
  // Below what scrolls: a sentence is always seen, and its coming moves nothing from under the pointer.
  auto* foot = new QVBoxLayout;
  foot->setContentsMargins(8, 8, 8, 8);
  foot->setSpacing(8);
  refusal_ = new QLabel(this);
  refusal_->setObjectName("panel.robot.refusal");
  refusal_->setAccessibleName(tr("Why the change was refused"));
  refusal_->setProperty("role", "alarm");
  refusal_->setWordWrap(true);
  refusal_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  refusal_->hide();
  foot->addWidget(refusal_);
  new_ =
      pushButton("panel.robot.add", tr("New robot"), tr("Adds a robot of one joint to the scene, beside what it has."),
                 this, tr("Add a robot to the scene"));
  remove_ = pushButton("panel.robot.remove", tr("Remove robot"),
                       tr("Takes the robot that is shown out of the scene; something must stay to be held to."), this,
                       tr("Remove the robot that is shown from the scene"));
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(4);
  for (QPushButton* button : {new_, remove_}) buttons->addWidget(button);
  foot->addLayout(buttons);
  outer->addLayout(foot);
}

void RobotPanel::connectSections() {
  connect(chooser_, &QComboBox::currentIndexChanged, this, [this](int row) { choose(row); });
  connect(new_, &QPushButton::clicked, this, [this] { addRobot(); });
  connect(remove_, &QPushButton::clicked, this, [this] { removeRobot(); });
  connect(pull_, &PullSection::koAsked, this, [this](double ko, bool fresh) { setKo(ko, fresh); });
  connect(pull_, &PullSection::orientationAsked, this, &RobotPanel::setOrientation);
  connect(pull_, &PullSection::lawAsked, this, &RobotPanel::setLaw);
  connect(chain_, &ChainSection::typed, this, &RobotPanel::setJoint);
  connect(chain_, &ChainSection::addAsked, this, &RobotPanel::addJoint);
  connect(chain_, &ChainSection::removeAsked, this, &RobotPanel::removeJoint);
  connect(chain_, &ChainSection::moveAsked, this, &RobotPanel::moveJoint);
  connect(home_, &HomeSection::typed, this, &RobotPanel::setHome);
  connect(solver_, &SolverSection::methodAsked, this, &RobotPanel::setMethod);
  connect(solver_, &SolverSection::stepsAsked, this, &RobotPanel::setMaxSteps);
  connect(solver_, &SolverSection::toleranceAsked, this, &RobotPanel::setTolerance);
}

}  // namespace underact::gui
