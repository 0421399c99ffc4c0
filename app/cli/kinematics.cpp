#include <cmath>
#include <memory>
#include <ostream>
#include <string>

#include "app/cli/arm_choice.h"
#include "app/cli/json_lines.h"
#include "core/kinematics/forward.h"
#include "core/kinematics/statics.h"

namespace underact::cli {
namespace {

using chain::JointValues;
using json::Value;
using kinematics::SolvedArm;

constexpr const char* kJoints = "{\"q_rad\": [q1, q2, q3, q4, q5, q6]}";
constexpr const char* kJointsAndWrench = "{\"q_rad\": [q1, ...], \"f_N\": [3], \"moment_N_mm\": [3]}";

using Answering = Result<JsonObject> (*)(const SolvedArm& arm, const JointValues& q, const Value& line);

/// Answers lines of joint values with one arm; further keys of a line are a wrench.
Exit answerJoints(const AskedArm& asked, const Streams& streams, const char* example, Answering answer) {
  const Result<SolvedArm> choice = askedArm(asked, streams.err);
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

Result<JsonObject> poseAnswer(const SolvedArm& arm, const JointValues& q, const Value&) {
  JsonObject object;
  object.addMatrix("X_WT", kinematics::poseOf(arm, q));
  return object;
}

Result<JsonObject> jacobianAnswer(const SolvedArm& arm, const JointValues& q, const Value&) {
  const kinematics::Dexterity dexterity = kinematics::dexterityOf(arm, q);
  JsonObject object;
  object.addMatrix("J", kinematics::jacobianOf(arm, q));
  if (kinematics::sixTurn(arm)) object.addNumber("det_Jp", dexterity.det_mm3);
  object.addNumber("manipulability_Jp", dexterity.manipulability);
  object.addNumber("condition_Jp", dexterity.condition);  // null: not defined
  object.addTexts("singular", {dexterity.singular.begin(), dexterity.singular.end()});
  return object;
}

/// A vector of a line, 0 where it is left out.
Result<Vec3> vectorOf(const Value& line, const char* key) {
  Vec3 vector = Vec3::Zero();
  const Value* const list = line.find(key);
  if (list == nullptr) return vector;
  bool whole = list->kind == json::JsonKind::Array && list->items.size() == 3;
  for (std::size_t i = 0; whole && i < 3; ++i) {
    whole = list->items[i].kind == json::JsonKind::Number && std::abs(list->items[i].number) <= 1e6;
    vector[static_cast<Eigen::Index>(i)] = list->items[i].number;
  }
  if (!whole) return Problems{{std::string("\"") + key + "\" must be three numbers of magnitude 1e6 or less.", {}}};
  return vector;
}

Result<JsonObject> staticsAnswer(const SolvedArm& arm, const JointValues& q, const Value& line) {
  const Result<Vec3> f_N = vectorOf(line, "f_N"), m_N_mm = vectorOf(line, "moment_N_mm");
  if (!f_N) return f_N.problems();
  if (!m_N_mm) return m_N_mm.problems();
  const kinematics::Statics statics = kinematics::staticsOf(arm, q, f_N.value(), m_N_mm.value());
  JsonObject object;
  object.addList("torque_N_mm", statics.torque);
  if (!statics.holding.empty()) object.addList("holding_N_mm", statics.holding);
  std::vector<std::string> driven;
  for (std::size_t i = 0; i < arm.joints(); ++i) {
    if (arm.model.joints[i].driven) driven.push_back("q" + std::to_string(i + 1));
  }
  object.addTexts("driven", driven);
  object.addList("gains_mm", statics.gains_mm);
  object.addMatrix("axes_W", statics.axes_W);
  return object;
}

void addCommand(Command program, const Streams& streams, Exit& exit, const char* name, const char* what,
                const char* out, Answering answer, const char* example = kJoints) {
  const Command command = program.add(name, what);
  const auto arm = std::make_shared<AskedArm>();
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
