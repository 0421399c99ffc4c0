#include "core/chain/kinematics.h"

#include <cmath>
#include <memory>
#include <ostream>
#include <string>

#include "app/cli/arm_choice.h"
#include "app/cli/json_lines.h"
#include "core/arm/branches.h"
#include "core/arm/forward.h"
#include "core/arm/jacobian.h"
#include "core/base/units.h"

namespace underact::cli {
namespace {

constexpr const char* kJoints = "{\"q_rad\": [q1, q2, q3, q4, q5, q6]}";
constexpr double kNoVolume_mm3 = 1e-6;  // a determinant under it is the rounding of the angles

/// Answers lines of joint angles with one arm.
Exit answerJoints(const std::string& arm, const Streams& streams,
                  JsonObject (*answer)(const ArmChoice& arm, const arm::JointAngles& q_rad)) {
  const Result<ArmChoice> choice = chooseArm(arm);
  if (!choice) return refuseArm(choice.problems(), streams.err);
  return answerLines(streams, [&](std::string_view text) -> Result<JsonObject> {
    const Result<json::Value> line = readLine(text, {"q_rad"}, kJoints);
    if (!line) return line.problems();
    const Result<arm::JointAngles> q_rad = readJoints(line.value(), "q_rad");
    if (!q_rad) return q_rad.problems();
    return answer(choice.value(), q_rad.value());
  });
}

JsonObject poseAnswer(const ArmChoice& arm, const arm::JointAngles& q_rad) {
  const Pose X_WT = arm.omni ? arm::tipPose(*arm.omni, q_rad) : chain::forward(arm.chain, q_rad);
  JsonObject object;
  Eigen::Matrix4d X = X_WT.matrix();
  X.topRightCorner<3, 1>() *= kMillimetrePerMetre;
  object.addMatrix("X_WT", X);
  return object;
}

/// Which singularities the joints are at.
std::vector<std::string> singularities(const ArmChoice& arm, const arm::JointAngles& q_rad, const Mat6& J,
                                       double det_Jp_m3) {
  std::vector<std::string> names;
  if (arm.omni) {
    const arm::SingularityDistances at = arm::singularityDistances(*arm.omni, q_rad);
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

JsonObject jacobianAnswer(const ArmChoice& arm, const arm::JointAngles& q_rad) {
  const Mat6 J = arm.omni ? arm::kinematics(*arm.omni, q_rad).J : Mat6(chain::jacobian(arm.flange, q_rad));
  const Mat3 Jp = J.topLeftCorner<3, 3>();
  const double det_m3 = arm.omni ? arm::dexterity(*arm.omni, q_rad).det_m3 : Jp.determinant();
  const double det_mm3 = det_m3 * 1e9;
  double condition = kNotANumber;
  if (std::abs(det_mm3) >= kNoVolume_mm3) {
    const Vec3 gain_m = arm.omni ? arm::dexterity(*arm.omni, q_rad).gain_m : Vec3(Jp.jacobiSvd().singularValues());
    condition = gain_m[0] / gain_m[2];
  }
  Mat6 J_mm = J;
  J_mm.topRows<3>() *= kMillimetrePerMetre;
  JsonObject object;
  object.addMatrix("J", J_mm);
  object.addNumber("det_Jp", det_mm3);
  object.addNumber("manipulability_Jp", std::abs(det_mm3));
  object.addNumber("condition_Jp", condition);  // null: not defined
  object.addTexts("singular", singularities(arm, q_rad, J, det_m3));
  return object;
}

void addCommand(Command program, const Streams& streams, Exit& exit, const char* name, const char* what,
                const char* out, JsonObject (*answer)(const ArmChoice& arm, const arm::JointAngles& q_rad)) {
  const Command command = program.add(name, what);
  const auto arm = std::make_shared<std::string>();
  addArmOption(command, *arm);
  command.footer(std::string("Each line in is ") + kJoints + ", DH angles; each line out is " + out +
                 ",\nor {\"error\", \"line\"}.\n\n" + listOfArms());
  command.whenChosen([arm, &streams, &exit, answer] { exit = answerJoints(*arm, streams, answer); });
}

}  // namespace

void addForward(Command program, const Streams& streams, Exit& exit) {
  addCommand(program, streams, exit, "fk", "Forward kinematics: the pose of the stylus for joint angles, line by line",
             "{\"X_WT\": 4x4 in mm}", poseAnswer);
}

void addJacobian(Command program, const Streams& streams, Exit& exit) {
  addCommand(program, streams, exit, "jacobian", "The Jacobian for joint angles, line by line",
             "{\"J\": 6x6 (v in mm/rad, then w; in W, at the origin of frame 6), \"det_Jp\" in mm^3, \n"
             "\"manipulability_Jp\", \"condition_Jp\" (null: singular), \"singular\": names}",
             jacobianAnswer);
}

}  // namespace underact::cli
