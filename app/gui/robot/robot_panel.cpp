#include "app/gui/robot/robot_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>
#include <cstdlib>
#include <optional>

#include "app/gui/kit/words.h"
#include "app/gui/model/document.h"
#include "app/gui/robot/sections.h"
#include "core/scene/compile.h"
#include "core/scene/edit.h"

namespace underact::gui {
namespace {

std::vector<std::size_t> robotsOf(const scene::Description& scene) {
  std::vector<std::size_t> robots;
  for (std::size_t index = 0; index < scene.constraints.size(); ++index) {
    if (std::holds_alternative<scene::VirtualManipulator>(scene.constraints[index].shape)) robots.push_back(index);
  }
  return robots;
}

}  // namespace

RobotPanel::RobotPanel(const Parts& parts, QWidget* parent) : Panel(parent), parts_(parts) {
  build();
  connectSections();
  addCommands();
  connect(&parts_.document, &Document::opened, this, &RobotPanel::sceneOpened);
  connect(&parts_.document, &Document::edited, this, &RobotPanel::refresh);
  sceneOpened();
}

const scene::VirtualManipulator* RobotPanel::robot() const {
  const std::vector<scene::Constraint>& constraints = parts_.document.scene().constraints;
  return index_ < constraints.size() ? std::get_if<scene::VirtualManipulator>(&constraints[index_].shape) : nullptr;
}

void RobotPanel::sceneOpened() {
  name_.clear();
  refusal_->hide();
  refresh();
}

void RobotPanel::listRobots() {
  const scene::Description& scene = parts_.document.scene();
  const std::vector<std::size_t> robots = robotsOf(scene);
  const QSignalBlocker silent(chooser_);
  chooser_->clear();
  index_ = robots.empty() ? scene.constraints.size() : robots.front();
  for (std::size_t number = 0; number < robots.size(); ++number) {
    const std::string& name = scene.constraints[robots[number]].name;
    chooser_->addItem(QString::fromStdString(name));
    if (name != name_) continue;
    index_ = robots[number];
    chooser_->setCurrentIndex(static_cast<int>(number));
  }
  name_ = robots.empty() ? std::string() : scene.constraints[index_].name;
  choices_->setRowVisible(chooser_, robots.size() > 1);
}

void RobotPanel::refresh() {
  listRobots();
  const scene::VirtualManipulator* shown = robot();
  editor_->setVisible(shown != nullptr);
  none_->setVisible(shown == nullptr);
  remove_->setEnabled(shown != nullptr && parts_.document.scene().constraints.size() > 1);
  new_->setEnabled(!parts_.document.scene().constraints.empty());
  if (shown == nullptr) return;
  const auto* const own = std::get_if<scene::VirtualManipulator>(&parts_.document.written(index_).shape);
  pull_->present(*shown, own != nullptr ? std::optional(own->ko_N_mm_per_rad) : std::nullopt);
  chain_->present(*shown);
  home_->present(shown->X_WV_home);
  solver_->present(shown->solver);
  const Result<tick::TickProgram> program = scene::compile(parts_.document.scene());
  if (program) now_->setRobot(std::get<manipulator::Manipulator>(program.value().entries[index_].constraint.goal));
  shown_ns_ = -1;
}

void RobotPanel::present(const servo::Snapshot& snapshot) {
  if (robot() == nullptr || !isSeen()) return;
  if (snapshot.revision != parts_.servo.revision() || index_ >= snapshot.report.held.size()) return;
  const std::int64_t now_ns = snapshot.report.sample.time_ns;
  if (shown_ns_ >= 0 && std::abs(now_ns - shown_ns_) < kBetweenNumbers_ns) return;
  shown_ns_ = now_ns;
  now_->present(snapshot.report.held[index_]);
}

bool RobotPanel::refuse(const Problems& problems) {
  refusal_->setText(problems.empty() ? QString() : sentencesOf(problems));
  refusal_->setVisible(!problems.empty());
  return problems.empty();
}

bool RobotPanel::send(const scene::Description& edited, const QString& what, bool fresh) {
  if (fresh) gesture_ = parts_.document.newGesture();
  const Problems problems = parts_.document.edit(edited, what, gesture_);
  refresh();  // refused? what holds is back
  return refuse(problems);
}

bool RobotPanel::change(const QString& what, bool fresh, const Change& change) {
  const scene::VirtualManipulator* shown = robot();
  if (shown == nullptr) return false;
  scene::VirtualManipulator edited = *shown;
  const Problems problems = change(edited);
  if (problems.empty()) return send(scene::withShape(parts_.document.scene(), index_, edited), what, fresh);
  refresh();
  return refuse(problems);
}

bool RobotPanel::choose(int number) {
  const std::vector<std::size_t> robots = robotsOf(parts_.document.scene());
  if (number < 0 || static_cast<std::size_t>(number) >= robots.size()) return false;
  name_ = parts_.document.scene().constraints[robots[static_cast<std::size_t>(number)]].name;
  gesture_ = parts_.document.newGesture();  // keys in a row on another robot are another step back
  refresh();
  return true;
}

}  // namespace underact::gui
