#include "app/gui/robot/robot_edits.h"

#include <algorithm>
#include <utility>

#include "app/gui/arms/joint_fields.h"
#include "app/gui/kit/actions.h"
#include "app/gui/model/document.h"
#include "app/gui/model/setting_words.h"
#include "core/scene/edit.h"

namespace underact::gui {
namespace {

constexpr double kDefaultKo_N_mm_per_rad = 100.0;

std::vector<std::size_t> robotsOf(const scene::Description& scene) {
  std::vector<std::size_t> robots;
  for (std::size_t index = 0; index < scene.constraints.size(); ++index) {
    if (std::holds_alternative<scene::VirtualManipulator>(scene.constraints[index].shape)) robots.push_back(index);
  }
  return robots;
}

bool isJoint(const scene::VirtualManipulator& robot, int joint) {
  return joint >= 0 && static_cast<std::size_t>(joint) < robot.joints.size();
}

Problems noSuchJoint() {
  return {{QObject::tr("There is no such joint.").toStdString(), {}}};
}

int fieldOf(const QString& key) {
  for (int field = 0; field < kJointFields; ++field) {
    if (keyOf(static_cast<JointField>(field)) == key) return field;
  }
  return -1;
}

}  // namespace

RobotEdits::RobotEdits(Document& document, QObject* parent) : QObject(parent), document_(document) {}

std::vector<std::size_t> RobotEdits::poll() {
  const std::vector<scene::Constraint>& constraints = document_.scene().constraints;
  std::vector<std::size_t> robots = robotsOf(document_.scene());
  const auto same =
      std::find_if(robots.begin(), robots.end(), [&](std::size_t index) { return constraints[index].name == name_; });
  index_ = robots.empty() ? constraints.size() : same == robots.end() ? robots.front() : *same;
  name_ = robots.empty() ? std::string() : constraints[index_].name;
  return robots;
}

const scene::VirtualManipulator* RobotEdits::robot() const {
  const std::vector<scene::Constraint>& constraints = document_.scene().constraints;
  return index_ < constraints.size() ? std::get_if<scene::VirtualManipulator>(&constraints[index_].shape) : nullptr;
}

const Vec3& RobotEdits::angles_deg() {
  const Mat3 R_WV = robot()->X_WV_home.topLeftCorner<3, 3>();
  if (!rotationOf(angles_deg_).isApprox(R_WV, 1e-9)) angles_deg_ = anglesOf_deg(R_WV);
  return angles_deg_;
}

bool RobotEdits::choose(int number) {
  const std::vector<std::size_t> robots = robotsOf(document_.scene());
  if (number < 0 || static_cast<std::size_t>(number) >= robots.size()) return false;
  name_ = document_.scene().constraints[robots[static_cast<std::size_t>(number)]].name;
  gesture_ = document_.newGesture();  // keys in a row on another robot are a new undo step
  emit chosen();
  return true;
}

bool RobotEdits::refuse(const Problems& problems) {
  emit asked(problems);
  return problems.empty();
}

bool RobotEdits::send(const scene::Description& edited, const QString& what, bool fresh) {
  if (fresh) gesture_ = document_.newGesture();
  return refuse(document_.edit(edited, what, gesture_));
}

bool RobotEdits::change(const QString& what, const Change& change) {
  const scene::VirtualManipulator* shown = robot();
  if (shown == nullptr) return false;
  scene::VirtualManipulator edited = *shown;
  const Problems problems = change(edited);
  return problems.empty() ? send(scene::withShape(document_.scene(), index_, edited), what, true) : refuse(problems);
}

bool RobotEdits::set(const std::string& path, const scene::SettingValue& value, bool fresh) {
  const scene::VirtualManipulator* const before = robot();
  if (before == nullptr) return false;
  const std::string here = "/constraints/" + std::to_string(index_);
  Result<scene::Description> edited = scene::withValue(document_.scene(), here + path, value);
  if (!edited) return refuse(edited.problems());
  auto& robot = std::get<scene::VirtualManipulator>(edited.value().constraints[index_].shape);
  // If no part of the orientation is followed, a rotational stiffness is refused; when one is followed again, it should
  // be felt.
  if (path == "/orientation" && robot.orientation == manipulator::Orientation::None) {
    robot.ko_N_mm_per_rad = 0.0;
  } else if (path == "/orientation" && before->orientation == manipulator::Orientation::None) {
    const auto* const own = std::get_if<scene::VirtualManipulator>(&document_.written(index_).shape);
    robot.ko_N_mm_per_rad =
        own != nullptr && own->ko_N_mm_per_rad > 0.0 ? own->ko_N_mm_per_rad : kDefaultKo_N_mm_per_rad;
  }
  return send(edited.value(), settingLabel(here + path), fresh);
}

bool RobotEdits::setJoint(int joint, int field, const QString& text) {
  return change(tr("joint %1, %2").arg(joint + 1).arg(headOf(static_cast<JointField>(field)).simplified()),
                [&](scene::VirtualManipulator& robot) {
                  if (!isJoint(robot, joint)) return noSuchJoint();
                  scene::Joint& edited = robot.joints[static_cast<std::size_t>(joint)];
                  const Result<scene::Joint> typed = withField(edited, static_cast<JointField>(field), text);
                  if (!typed) return typed.problems();
                  edited = typed.value();
                  return Problems{};
                });
}

bool RobotEdits::addJoint(int after) {
  const scene::VirtualManipulator* const shown = robot();
  if (shown != nullptr && shown->orientation == manipulator::Orientation::Angle)
    return refuse(
        {{tr("This robot follows the angle about its one joint. At “Follows”, choose “%1” first; then add the "
             "joint.")
              .arg(settingChoice("/constraints/*/orientation", "axis"))
              .toStdString(),
          {}}});
  const bool added = change(tr("add a joint"), [&](scene::VirtualManipulator& robot) {
    if (!isJoint(robot, after)) return noSuchJoint();
    robot.joints.insert(robot.joints.begin() + after + 1, nextJoint(robot, static_cast<std::size_t>(after)));
    return Problems{};
  });
  if (added) emit jointMoved(after + 1);
  return added;
}

bool RobotEdits::removeJoint(int joint) {
  return change(tr("remove a joint"), [&](scene::VirtualManipulator& robot) {
    if (!isJoint(robot, joint)) return noSuchJoint();
    robot.joints.erase(robot.joints.begin() + joint);
    return Problems{};
  });
}

bool RobotEdits::moveJoint(int joint, int by) {
  const bool moved = change(tr("move a joint"), [&](scene::VirtualManipulator& robot) {
    if (!isJoint(robot, joint) || !isJoint(robot, joint + by)) return noSuchJoint();
    std::swap(robot.joints[static_cast<std::size_t>(joint)], robot.joints[static_cast<std::size_t>(joint + by)]);
    return Problems{};
  });
  if (moved) emit jointMoved(joint + by);
  return moved;
}

bool RobotEdits::setHome(int row, int axis, const QString& text) {
  return change(row == 0 ? tr("home position") : tr("home orientation"), [&](scene::VirtualManipulator& robot) {
    const Result<double> typed = typedNumber(text);
    if (!typed) return typed.problems();
    if (row == 0) {
      robot.X_WV_home(axis, 3) = typed.value();
    } else {
      angles_deg();
      angles_deg_[axis] = typed.value();
      robot.X_WV_home.topLeftCorner<3, 3>() = rotationOf(angles_deg_);
    }
    return Problems{};
  });
}

bool RobotEdits::addRobot() {
  const scene::Description& scene = document_.scene();
  if (scene.constraints.empty()) return false;
  scene::Constraint constraint;
  constraint.name = tr("robot").toStdString();
  constraint.shape = newRobot();
  const scene::Description edited = scene::withAdded(scene, constraint);
  const std::string before = std::exchange(name_, edited.constraints.back().name);  // shown as soon as it exists
  const bool added = send(edited, tr("new robot"), true);
  if (!added) name_ = before;
  return added;
}

bool RobotEdits::removeRobot() {
  const scene::Description& scene = document_.scene();
  if (robot() == nullptr || scene.constraints.size() < 2) return false;
  return send(scene::without(scene, index_), tr("remove the robot"), true);
}

void RobotEdits::addCommands(Actions& actions) {
  // joint: from 1. joint.set: joint, field, value; joint.add: after which; joint.move: joint, by.
  const auto add = [&actions](const char* name, int values, auto run) {
    actions.addCommand(name, [values, run](const QVariantList& given) { return given.size() == values && run(given); });
  };
  add("robot.choose", 1, [this](const QVariantList& v) { return choose(v[0].toInt() - 1); });
  add("robot.add", 0, [this](const QVariantList&) { return addRobot(); });
  add("robot.remove", 0, [this](const QVariantList&) { return removeRobot(); });
  const auto addSetting = [&add, this](const char* name, const char* path) {
    add(name, 1, [path, this](const QVariantList& v) { return set(path, v[0].toString().toStdString(), true); });
  };
  add("robot.ko.set", 1, [this](const QVariantList& v) { return set("/ko_N_mm_per_rad", v[0].toDouble(), true); });
  addSetting("robot.orientation.set", "/orientation");
  addSetting("robot.law.set", "/force_law");
  add("robot.solver.set", 2, [this](const QVariantList& v) {
    const std::string path = "/solver/" + v[0].toString().toStdString();
    const scene::Setting* const setting = scene::findSetting("/constraints/*" + path);
    if (setting == nullptr) return false;
    if (setting->kind == scene::SettingKind::Choice) return set(path, v[1].toString().toStdString(), true);
    const Result<double> number = typedNumber(v[1].toString());
    return number ? set(path, number.value(), true) : refuse(number.problems());
  });
  add("robot.joint.set", 3, [this](const QVariantList& v) {
    const int field = fieldOf(v[1].toString());
    return field >= 0 && setJoint(v[0].toInt() - 1, field, v[2].toString());
  });
  add("robot.joint.add", 1, [this](const QVariantList& v) { return addJoint(v[0].toInt() - 1); });
  add("robot.joint.remove", 1, [this](const QVariantList& v) { return removeJoint(v[0].toInt() - 1); });
  add("robot.joint.move", 2, [this](const QVariantList& v) { return moveJoint(v[0].toInt() - 1, v[1].toInt()); });
  add("robot.home.set", 3, [this](const QVariantList& v) {  // "place" or "turn", "x", number
    const auto row = QStringList{"place", "turn"}.indexOf(v[0].toString());
    const auto axis = QStringList{"x", "y", "z"}.indexOf(v[1].toString());
    return row >= 0 && axis >= 0 && setHome(static_cast<int>(row), static_cast<int>(axis), v[2].toString());
  });
}

}  // namespace underact::gui
