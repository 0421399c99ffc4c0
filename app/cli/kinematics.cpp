#include "core/chain/kinematics.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>
#include <string>

#include "app/cli/arm_choice.h"
#include "app/cli/json_lines.h"
#include "core/arm/branches.h"
#include "core/arm/forward.h"
#include "core/arm/gravity.h"
#include "core/arm/jacobian.h"
#include "core/base/units.h"
#include "core/chain/statics.h"

namespace underact::cli {
namespace {

using chain::JointValues;
using json::Value;

constexpr const char* kJoints = "{\"q_rad\": [q1, q2, q3, q4, q5, q6]}";
constexpr const char* kJointsAndWrench = "{\"q_rad\": [q1, ...], \"f_N\": [3], \"moment_N_mm\": [3]}";
constexpr double kNoVolume_mm3 = 1e-6;  // a determinant under it is the rounding of the angles
constexpr double kGravity_m_per_s2 = 9.80665;

/// The joints of an Omni's straight-line code.
arm::JointAngles sixOf(const JointValues& q) {
  arm::JointAngles q_rad{};
  std::copy_n(q.begin(), q_rad.size(), q_rad.begin());
  return q_rad;
}

std::span<const double> onlyJoints(const ArmChoice& arm, const JointValues& q) {
  return std::span(q).first(arm.joints());
}

using Answering = Result<JsonObject> (*)(const ArmChoice& arm, const JointValues& q, const Value& line);

/// Answers lines of joint values with one arm; further keys of a line are a wrench.
Exit answerJoints(const std::string& arm, const Streams& streams, const char* example, Answering answer) {
  const Result<ArmChoice> choice = chooseArm(arm);
  if (!choice) return refuseArm(choice.problems(), streams.err);
  return answerLines(streams, [&](std::string_view text) -> Result<JsonObject> {
    const Result<Value> line = example == kJoints ? readLine(text, {"q_rad"}, example)
                                                  : readLine(text, {"q_rad"}, example, {"f_N", "moment_N_mm"});
    if (!line) return line.problems();
    const Result<JointValues> q = readJoints(line.value(), "q_rad", choice.value().chain());
    if (!q) return q.problems();
    return answer(choice.value(), q.value(), line.value());
  });
}

Result<JsonObject> poseAnswer(const ArmChoice& arm, const JointValues& q, const Value&) {
  const Pose X_WT = arm.omni ? arm::tipPose(*arm.omni, sixOf(q)) : chain::forward(arm.chain(), onlyJoints(arm, q));
  JsonObject object;
  Eigen::Matrix4d X = X_WT.matrix();
  X.topRightCorner<3, 1>() *= kMillimetrePerMetre;
  object.addMatrix("X_WT", X);
  return object;
}

/// Which singularities the joints of an arm of six are at.
std::vector<std::string> singularities(const ArmChoice& arm, const JointValues& q, const Mat6& J, double det_Jp_m3) {
  std::vector<std::string> names;
  if (arm.omni) {
    const arm::SingularityDistances at = arm::singularityDistances(*arm.omni, sixOf(q));
    if (at.shoulder_m < arm::kSingularDistance_m) names.emplace_back("shoulder");
    if (at.elbow_rad < arm::kSingularSine) names.emplace_back("elbow");
    if (at.wrist_rad < arm::kSingularSine) names.emplace_back("wrist");
    return names;
  }
  const double reach_m = chain::reachOf(arm.flange);
  if (std::abs(det_Jp_m3) < arm::kSingularSine * reach_m * reach_m * reach_m) names.emplace_back("position");
  if (arm.closed && std::abs(J.bottomRightCorner<3, 3>().determinant()) < arm::kSingularSine)
    names.emplace_back("wrist");
  return names;
}

/// Rates as lines have them: mm for m, of the tip and of joints that slide.
Eigen::MatrixXd inMillimetres(const ArmChoice& arm, const chain::Jacobian& J) {
  Eigen::MatrixXd J_mm = J;
  J_mm.topRows(3) *= kMillimetrePerMetre;
  for (std::size_t i = 0; i < arm.joints(); ++i) {
    if (arm.chain().joints[i].type == chain::JointType::Prismatic)
      J_mm.col(static_cast<Eigen::Index>(i)) *= kMetrePerMillimetre;
  }
  return J_mm;
}

/// Of six joints that all turn, with the block of the first three, as it always was.
JsonObject jacobianOfSix(const ArmChoice& arm, const JointValues& q) {
  const Mat6 J =
      arm.omni ? arm::kinematics(*arm.omni, sixOf(q)).J : Mat6(chain::jacobian(arm.flange, onlyJoints(arm, q)));
  const Mat3 Jp = J.topLeftCorner<3, 3>();
  const double det_m3 = arm.omni ? arm::dexterity(*arm.omni, sixOf(q)).det_m3 : Jp.determinant();
  const double det_mm3 = det_m3 * 1e9;
  double condition = kNotANumber;
  if (std::abs(det_mm3) >= kNoVolume_mm3) {
    const Vec3 gain_m = arm.omni ? arm::dexterity(*arm.omni, sixOf(q)).gain_m : Vec3(Jp.jacobiSvd().singularValues());
    condition = gain_m[0] / gain_m[2];
  }
  JsonObject object;
  object.addMatrix("J", inMillimetres(arm, J));
  object.addNumber("det_Jp", det_mm3);
  object.addNumber("manipulability_Jp", std::abs(det_mm3));
  object.addNumber("condition_Jp", condition);  // null: not defined
  object.addTexts("singular", singularities(arm, q, J, det_m3));
  return object;
}

bool sixTurn(const ArmChoice& arm) {
  const std::vector<chain::Joint>& joints = arm.chain().joints;
  const auto turns = [](const chain::Joint& joint) { return joint.type == chain::JointType::Revolute; };
  return joints.size() == 6 && std::all_of(joints.begin(), joints.end(), turns);
}

std::vector<bool> drivenOf(const ArmChoice& arm) {
  std::vector<bool> driven;
  for (const arm::JointFacts& facts : arm.model.joints) driven.push_back(facts.driven);
  return driven;
}

Result<JsonObject> jacobianAnswer(const ArmChoice& arm, const JointValues& q, const Value&) {
  if (sixTurn(arm)) return jacobianOfSix(arm, q);
  const chain::Jacobian J = chain::jacobian(arm.flange, onlyJoints(arm, q));
  const chain::Ellipsoid all = chain::positionEllipsoid(J, {});
  JsonObject object;
  object.addMatrix("J", inMillimetres(arm, J));
  object.addNumber("manipulability_Jp",
                   all.manipulability * std::pow(kMillimetrePerMetre, std::min(3.0, static_cast<double>(J.cols()))));
  object.addNumber("condition_Jp", std::isfinite(all.condition) ? all.condition : kNotANumber);
  const bool lost =
      all.gain[std::min<std::size_t>(3, arm.joints()) - 1] < arm::kSingularSine * chain::reachOf(arm.flange);
  object.addTexts("singular", lost ? std::vector<std::string>{"position"} : std::vector<std::string>{});
  return object;
}

/// A vector of a line, 0 where it is left out.
Result<Vec3> vectorOf(const Value& line, const char* key) {
  Vec3 vector = Vec3::Zero();
  const Value* const list = line.find(key);
  if (list == nullptr) return vector;
  bool whole = list->kind == json::Kind::Array && list->items.size() == 3;
  for (std::size_t i = 0; whole && i < 3; ++i) {
    whole = list->items[i].kind == json::Kind::Number && std::abs(list->items[i].number) <= 1e6;
    vector[static_cast<Eigen::Index>(i)] = list->items[i].number;
  }
  if (!whole) return Problems{{std::string("\"") + key + "\" must be three numbers of magnitude 1e6 or less.", {}}};
  return vector;
}

std::vector<double> torqueNumbers(const ArmChoice& arm, std::vector<double> torques) {
  for (std::size_t i = 0; i < torques.size(); ++i) {
    if (arm.chain().joints[i].type == chain::JointType::Revolute) torques[i] *= kMillimetrePerMetre;
  }
  return torques;
}

Result<JsonObject> staticsAnswer(const ArmChoice& arm, const JointValues& q, const Value& line) {
  const Result<Vec3> f_N = vectorOf(line, "f_N"), m_N_mm = vectorOf(line, "moment_N_mm");
  if (!f_N) return f_N.problems();
  if (!m_N_mm) return m_N_mm.problems();
  const chain::Jacobian J = chain::jacobian(arm.chain(), onlyJoints(arm, q));
  Vec6 wrench;
  wrench << f_N.value(), kMetrePerMillimetre * m_N_mm.value();
  const chain::Ellipsoid ellipsoid = chain::positionEllipsoid(J, drivenOf(arm));
  JsonObject object;
  object.addList("torque_N_mm", torqueNumbers(arm, chain::torquesOf(J, wrench)));
  // The workspace of a haptic arm has y up; another robot stands in a frame with z up.
  const Vec3 down_m_per_s2 = -kGravity_m_per_s2 * (arm.model.device ? Vec3::UnitY() : Vec3::UnitZ());
  const std::vector<double> weight = arm::holdingTorques(arm.model, onlyJoints(arm, q), down_m_per_s2);
  if (!weight.empty()) object.addList("holding_N_mm", torqueNumbers(arm, weight));
  std::vector<std::string> driven;
  for (std::size_t i = 0; i < arm.joints(); ++i) {
    if (arm.model.joints[i].driven) driven.push_back("q" + std::to_string(i + 1));
  }
  object.addTexts("driven", driven);
  std::array<double, 3> gains_mm{};
  Mat3 axes_W;
  for (std::size_t i = 0; i < 3; ++i) {
    gains_mm[i] = kMillimetrePerMetre * ellipsoid.gain[i];
    axes_W.row(static_cast<Eigen::Index>(i)) = ellipsoid.axis_W[i].transpose();
  }
  object.addList("gains_mm", gains_mm);
  object.addMatrix("axes_W", axes_W);
  return object;
}

void addCommand(Command program, const Streams& streams, Exit& exit, const char* name, const char* what,
                const char* out, Answering answer, const char* example = kJoints) {
  const Command command = program.add(name, what);
  const auto arm = std::make_shared<std::string>();
  addArmOption(command, *arm);
  command.footer(std::string("Each line in is ") + example +
                 ": DH angles, one entry for each joint, mm where it slides.\nEach line out is " + out +
                 ",\nor {\"error\", \"line\"}.\n\n" + listOfArms());
  command.whenChosen([arm, &streams, &exit, answer, example] { exit = answerJoints(*arm, streams, example, answer); });
}

}  // namespace

void addForward(Command program, const Streams& streams, Exit& exit) {
  addCommand(program, streams, exit, "fk", "Forward kinematics: the pose of the stylus for joint angles, line by line",
             "{\"X_WT\": 4x4 in mm}", poseAnswer);
}

void addJacobian(Command program, const Streams& streams, Exit& exit) {
  addCommand(
      program, streams, exit, "jacobian", "The Jacobian for joint angles, line by line",
      "{\"J\": 6x6 (v in mm/rad, then w; in W, at the origin of frame 6), \"det_Jp\" in mm^3, \n"
      "\"manipulability_Jp\", \"condition_Jp\" (null: singular), \"singular\": names}; of an arm that has not six "
      "joints\nJ has a column for each joint, at the tip, and there is no \"det_Jp\"",
      jacobianAnswer);
}

void addStatics(Command program, const Streams& streams, Exit& exit) {
  addCommand(
      program, streams, exit, "statics", "The joint torques for a force at the tip, line by line",
      "{\"torque_N_mm\": one entry for each joint (N where it slides), \"holding_N_mm\": those that hold the arm's "
      "own\n"
      "weight, z up, or y for a haptic arm (if its file has masses), \"driven\": joints, \"gains_mm\", \"axes_W\": "
      "the\n"
      "ellipsoid of tip velocities of the driven joints; that of forces has the same axes, and 1 / gain}",
      staticsAnswer, kJointsAndWrench);
}

}  // namespace underact::cli
