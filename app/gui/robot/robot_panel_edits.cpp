// What the Robot panel can be asked for: each an edit of the scene, by hand or by the name of a command.
#include <QComboBox>
#include <utility>

#include "app/gui/arms/joint_fields.h"
#include "app/gui/kit/actions.h"
#include "app/gui/model/document.h"
#include "app/gui/model/setting_words.h"
#include "app/gui/robot/robot_panel.h"
#include "app/gui/robot/sections.h"
#include "core/scene/edit.h"
#include "core/scene/fields.h"

namespace underact::gui {
namespace {

using manipulator::ForceLaw;
using manipulator::Orientation;

constexpr double kUsualKo_N_mm_per_rad = 100.0;

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

bool RobotPanel::set(const std::string& path, const scene::SettingValue& value, bool fresh) {
  if (robot() == nullptr) return false;
  const std::string whole = "/constraints/" + std::to_string(index_) + path;
  const Result<scene::Description> edited = scene::withValue(parts_.document.scene(), whole, value);
  if (edited) return send(edited.value(), settingLabel(whole), fresh);
  refresh();
  return refuse(edited.problems());
}

bool RobotPanel::setKo(double ko_N_mm_per_rad, bool fresh) {
  return set("/ko_N_mm_per_rad", ko_N_mm_per_rad, fresh);
}

bool RobotPanel::setOrientation(Orientation orientation) {
  const auto* const own = std::get_if<scene::VirtualManipulator>(&parts_.document.written(index_).shape);
  return change(settingLabel("/constraints/*/orientation"), true, [&](scene::VirtualManipulator& robot) {
    // Where nothing of the turn is followed a stiffness for it is refused; and back again it should be felt.
    const double own_ko = own != nullptr ? own->ko_N_mm_per_rad : 0.0;
    if (orientation == Orientation::None) {
      robot.ko_N_mm_per_rad = 0.0;
    } else if (robot.orientation == Orientation::None) {
      robot.ko_N_mm_per_rad = own_ko > 0.0 ? own_ko : kUsualKo_N_mm_per_rad;
    }
    robot.orientation = orientation;
    return Problems{};
  });
}

bool RobotPanel::setLaw(ForceLaw law) {
  return set("/force_law", std::string(wordOf(scene::kForceLawWords, law)), true);
}

bool RobotPanel::setMethod(scene::SolverMethod method) {
  return set("/solver/method", std::string(wordOf(scene::kSolverWords, method)), true);
}

bool RobotPanel::setMaxSteps(int max_steps) {
  return set("/solver/max_steps", static_cast<double>(max_steps), true);
}

bool RobotPanel::setTolerance(const QString& text) {
  const Result<double> typed = typedNumber(text);
  if (typed) return set("/solver/tolerance", typed.value(), true);
  refresh();
  return refuse(typed.problems());
}

bool RobotPanel::setJoint(int joint, int field, const QString& text) {
  return change(tr("joint %1, %2").arg(joint + 1).arg(headOf(static_cast<JointField>(field)).simplified()), true,
                [&](scene::VirtualManipulator& robot) {
                  if (!isJoint(robot, joint)) return noSuchJoint();
                  scene::Joint& edited = robot.joints[static_cast<std::size_t>(joint)];
                  const Result<scene::Joint> typed = withField(edited, static_cast<JointField>(field), text);
                  if (!typed) return typed.problems();
                  edited = typed.value();
                  return Problems{};
                });
}

bool RobotPanel::addJoint(int after) {
  const bool added = change(tr("add a joint"), true, [&](scene::VirtualManipulator& robot) {
    if (!isJoint(robot, after)) return noSuchJoint();
    robot.joints.insert(robot.joints.begin() + after + 1, nextJoint(robot, static_cast<std::size_t>(after)));
    return Problems{};
  });
  if (added) chain_->select(after + 1);
  return added;
}

bool RobotPanel::removeJoint(int joint) {
  return change(tr("remove a joint"), true, [&](scene::VirtualManipulator& robot) {
    if (!isJoint(robot, joint)) return noSuchJoint();
    robot.joints.erase(robot.joints.begin() + joint);
    return Problems{};
  });
}

bool RobotPanel::moveJoint(int joint, int by) {
  const bool moved = change(tr("move a joint"), true, [&](scene::VirtualManipulator& robot) {
    if (!isJoint(robot, joint) || !isJoint(robot, joint + by)) return noSuchJoint();
    std::swap(robot.joints[static_cast<std::size_t>(joint)], robot.joints[static_cast<std::size_t>(joint + by)]);
    return Problems{};
  });
  if (moved) chain_->select(joint + by);
  return moved;
}

bool RobotPanel::setHome(int row, int axis, const QString& text) {
  return change(row == 0 ? tr("tip at home") : tr("turn of the tip"), true, [&](scene::VirtualManipulator& robot) {
    const Result<double> typed = typedNumber(text);
    if (!typed) return typed.problems();
    if (row == 0) {
      robot.X_WV_home(axis, 3) = typed.value();
    } else {
      Vec3 angles_deg = home_->angles_deg();
      angles_deg[axis] = typed.value();
      robot.X_WV_home.topLeftCorner<3, 3>() = rotationOf(angles_deg);
      home_->keepAngles(angles_deg);
    }
    return Problems{};
  });
}

bool RobotPanel::addRobot() {
  const scene::Description& scene = parts_.document.scene();
  if (scene.constraints.empty()) return false;
  scene::Constraint constraint;
  constraint.name = tr("robot").toStdString();
  constraint.shape = newRobot();
  const scene::Description edited = scene::withAdded(scene, constraint);
  const std::string before = std::exchange(name_, edited.constraints.back().name);  // shown as soon as it is there
  const bool added = send(edited, tr("new robot"), true);
  if (!added) name_ = before;
  return added;
}

bool RobotPanel::removeRobot() {
  const scene::Description& scene = parts_.document.scene();
  if (robot() == nullptr || scene.constraints.size() < 2) return false;
  return send(scene::without(scene, index_), tr("remove the robot"), true);
}

void RobotPanel::addCommands() {
  Actions& actions = parts_.actions;
  // joint: from 1. joint.set: joint, field, value; joint.add: after which; joint.move: joint, by.
  const auto add = [&actions](const char* name, int values, auto run) {
    actions.addCommand(name, [values, run](const QVariantList& given) { return given.size() == values && run(given); });
  };
  add("robot.choose", 1, [this](const QVariantList& v) { return choose(v[0].toInt() - 1); });
  add("robot.add", 0, [this](const QVariantList&) { return addRobot(); });
  add("robot.remove", 0, [this](const QVariantList&) { return removeRobot(); });
  add("robot.ko.set", 1, [this](const QVariantList& v) { return setKo(v[0].toDouble(), true); });
  add("robot.orientation.set", 1, [this](const QVariantList& v) {
    for (const auto& word : scene::kOrientationWords) {
      if (v[0].toString() == word.word) return setOrientation(word.value);
    }
    return false;
  });
  add("robot.law.set", 1,
      [this](const QVariantList& v) { return set("/force_law", v[0].toString().toStdString(), true); });
  add("robot.solver.set", 2, [this](const QVariantList& v) {
    if (v[0].toString() == "max_steps") return setMaxSteps(v[1].toInt());
    if (v[0].toString() == "tolerance") return setTolerance(v[1].toString());
    return v[0].toString() == "method" && set("/solver/method", v[1].toString().toStdString(), true);
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
