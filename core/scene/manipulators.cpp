#include "core/scene/manipulators.h"

#include <cmath>
#include <utility>

#include "core/base/nearest_rotation.h"
#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/json/json.h"
#include "core/scene/rules.h"
#include "core/scene/setting_rows.h"

namespace underact::scene {
namespace {

using chain::JointType;
using json::numberText;

bool isTurning(const Joint& joint) {
  return joint.type == JointType::Revolute;
}

class JointChecker {
 public:
  JointChecker(const std::function<void(const std::string&, Sentence)>& add, bool& well) : add_(add), well_(well) {}

  void check(const std::string& key, const Joint& joint) const {
    if (!joint.axis.allFinite()) {
      say(key + ".axis",
          phrase(TRANSLATE_NOOP("problem", "This is not a finite direction; the largest number is about 1.8e308.")));
    } else if (joint.axis.isZero(0.0)) {
      say(key + ".axis", hasNoDirection());
    }
    if (isTurning(joint)) {
      for (Eigen::Index i = 0; i < 3; ++i) {
        say(key + ".point_mm[" + std::to_string(i) + "]", valueProblem(Meaning::Position, joint.point_mm[i]));
      }
    }
    checkSettings(joint, [&](const std::string& its, Sentence wrong) { say(key + "." + its, std::move(wrong)); });
    if (joint.min && joint.max && *joint.min > *joint.max) {
      say(key + ".min", phrase(TRANSLATE_NOOP("problem", "The lower limit %1 is above the upper limit %2."),
                               {numberText(*joint.min), numberText(*joint.max)}));
    }
    if (joint.stiffness == 0.0 && joint.rest != 0.0) {
      say(key + ".rest",
          phrase(TRANSLATE_NOOP("problem",
                                "Without a spring the joint has no rest position; give it \"%1\", or remove this."),
                 {stiffnessKey(joint.type)}));
    }
  }

  void say(const std::string& key, Sentence sentence) const {
    if (sentence.empty()) return;
    well_ = false;
    add_(key, std::move(sentence));
  }

 private:
  const std::function<void(const std::string&, Sentence)>& add_;
  bool& well_;
};

}  // namespace

bool checkManipulator(const VirtualManipulator& robot, const Control& control,
                      const std::function<void(const std::string&, Sentence)>& add) {
  bool well = true;
  const JointChecker checker(add, well);
  if (robot.joints.empty() || robot.joints.size() > manipulator::kMaxJoints) {
    checker.say("joints", jointCountProblem(robot.joints.size()));
  }
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    checker.check("joints[" + std::to_string(i) + "]", robot.joints[i]);
  }
  checker.say("X_WV_home", poseProblem(robot.X_WV_home));
  const auto say = [&](const std::string& key, Sentence wrong) { checker.say(key, std::move(wrong)); };
  checkSettings(robot, say);
  if (robot.orientation == manipulator::Orientation::None && robot.ko_N_mm_per_rad != 0.0) {
    checker.say("ko_N_mm_per_rad",
                phrase(TRANSLATE_NOOP("problem",
                                      "The orientation \"none\" does not use this; set \"orientation\" to \"axis\", "
                                      "\"angle\" or \"full\", or remove this.")));
  }
  checkSettings(robot.solver, [&](const std::string& key, Sentence wrong) { say("solver." + key, std::move(wrong)); });
  if (control.space == tick::Space::Joint) {
    checker.say(
        "",
        phrase(TRANSLATE_NOOP(
            "problem",
            "A virtual robot pulls the tip, which control in joint space cannot do. Set \"space\" to \"cartesian\".")));
  }
  const Vec3& kp = control.gains.kp_N_per_mm;
  if (control.anisotropy == Anisotropy::Euclidean && !(kp.x() == kp.y() && kp.y() == kp.z())) {
    checker.say("", phrase(TRANSLATE_NOOP("problem",
                                          "A virtual robot is held in the gains' own metric. Remove \"anisotropy\", or "
                                          "give every axis the same kp.")));
  }
  return well;
}

Result<manipulator::Manipulator> makeManipulator(const VirtualManipulator& robot, const Control& control,
                                                 const SourceLocation& place) {
  manipulator::Wanted wanted;
  std::vector<chain::Joint> joints;
  for (std::size_t i = 0; i < robot.joints.size() && i < manipulator::kMaxJoints; ++i) {
    const Joint& joint = robot.joints[i];
    const double unit = isTurning(joint) ? 1.0 : kMetrePerMillimetre;
    joints.push_back({joint.type, joint.axis, kMetrePerMillimetre * joint.point_mm,
                      joint.min ? unit * *joint.min : -kInfinity, joint.max ? unit * *joint.max : kInfinity});
    wanted.spring[i] = joint.stiffness * (isTurning(joint) ? kMetrePerMillimetre : kNewtonPerMetre);
    wanted.rest[i] = unit * joint.rest;
  }
  Pose X_WV_home = Pose::Identity();
  // A rotation written with a few digits is made exact.
  X_WV_home.linear() = nearestRotation(Mat3(robot.X_WV_home.topLeftCorner<3, 3>()));
  X_WV_home.translation() = kMetrePerMillimetre * robot.X_WV_home.topRightCorner<3, 1>();
  Result<chain::Chain> made = chain::makeChain(std::move(joints), X_WV_home, place);
  if (!made) return made.problems();
  wanted.chain = std::move(made).value();
  wanted.orientation = robot.orientation;
  wanted.kp_N_per_m = kNewtonPerMetre * control.gains.kp_N_per_mm;
  wanted.ko_N_m_per_rad = kMetrePerMillimetre * robot.ko_N_mm_per_rad;
  wanted.law = robot.force_law;
  if (robot.solver.method == SolverMethod::ClosedForm) wanted.method = manipulator::Method::ClosedForm;
  if (robot.solver.method == SolverMethod::Iterative) wanted.method = manipulator::Method::Iterative;
  wanted.max_steps = robot.solver.max_steps;
  wanted.tolerance = robot.solver.tolerance;
  return manipulator::makeManipulator(std::move(wanted), place);
}

}  // namespace underact::scene
