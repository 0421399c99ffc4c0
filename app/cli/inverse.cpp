#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>
#include <string>

#include "app/cli/arm_choice.h"
#include "app/cli/json_lines.h"
#include "app/cli/scene_file.h"
#include "core/arm/branches.h"
#include "core/base/units.h"
#include "core/chain/closed_form.h"
#include "core/chain/numeric_inverse.h"

namespace underact::cli {
namespace {

struct InverseOptions {
  std::string arm;
  std::string method = "auto";
  std::uint64_t seed = 1;
};

/// One solution, however it was found.
struct Found {
  arm::JointAngles q_rad{};
  const char* family = nullptr;
  bool has_branch = true;
  int shoulder = 1, elbow = 1, wrist = 1;
};

struct Answer {
  bool reachable = false;
  bool singular = false;
  std::vector<Found> found;
};

Answer byStraightLine(const ArmChoice& arm, const Pose& X_WT) {
  const arm::Solutions solutions = arm::solveAll(*arm.omni, arm.model.limits, X_WT);
  Answer answer{solutions.reachable, solutions.singular(), {}};
  for (const arm::Solution& one : solutions) {
    answer.found.push_back(
        {one.q_rad, name(one.family), true, one.branch.shoulder, one.branch.elbow, one.branch.wrist});
  }
  return answer;
}

/// The names of the free families of an arm whose wrist axes are aligned, |sin| of its bend being small.
const char* wristFamily(const ArmChoice& arm, const arm::JointAngles& q_rad) {
  const chain::Jacobian J = chain::jacobian(arm.flange, q_rad);
  const Vec3 four_W = J.col(3).tail<3>(), six_W = J.col(5).tail<3>();
  if (four_W.cross(six_W).norm() >= arm::kSingularSine) return nullptr;
  return four_W.dot(six_W) > 0.0 ? "q4+q6" : "q6-q4";
}

Answer byClosedForm(const ArmChoice& arm, const Pose& X_WT) {
  const chain::Solutions solutions = chain::solveAll(*arm.closed, X_WT);
  Answer answer{solutions.exact > 0, false, {}};
  const double reach_m = chain::reachOf(arm.flange);
  for (std::size_t index = 0; index < solutions.exact; ++index) {
    const chain::Solution& one = solutions.all[index];
    Found found{one.q, wristFamily(arm, one.q), true, one.shoulder, one.elbow, one.wrist};
    const Mat3 Jp = chain::jacobian(arm.flange, one.q).topLeftCorner<3, 3>();
    const bool placed = std::abs(Jp.determinant()) < arm::kSingularSine * reach_m * reach_m * reach_m;
    answer.singular |= placed || found.family != nullptr;
    answer.found.push_back(found);
  }
  return answer;
}

Answer byIteration(const ArmChoice& arm, const Pose& X_WT, std::uint64_t seed) {
  chain::NumericOptions options;
  options.restarts = 50;
  options.seed = seed;
  const arm::JointAngles start_rad{};
  const chain::NumericSolution solution = chain::solveNumerically(arm.chain, X_WT, start_rad, options);
  Answer answer{solution.reached, false, {}};
  if (!solution.reached) return answer;
  Found found;
  std::copy_n(solution.q.begin(), found.q_rad.size(), found.q_rad.begin());
  found.has_branch = false;
  answer.found.push_back(found);
  return answer;
}

bool isWithin(const arm::Model& model, const arm::JointAngles& q_rad) {
  if (model.limits_wrist_size) return arm::isWithin(model.limits, q_rad);
  for (std::size_t joint = 0; joint < q_rad.size(); ++joint) {
    // A joint with a range of more than one turn may be a turn away.
    const double low = model.limits.min_rad[joint], high = model.limits.max_rad[joint];
    const double turns = std::ceil((low - q_rad[joint]) / (2.0 * kPi));
    const double angle_rad = std::isfinite(turns) ? q_rad[joint] + 2.0 * kPi * turns : q_rad[joint];
    if (!(angle_rad <= high)) return false;
  }
  return true;
}

JsonObject solutionObject(const ArmChoice& arm, const Found& found) {
  JsonObject object;
  object.addList("q_rad", found.q_rad);
  if (found.has_branch) {
    JsonObject branch;
    branch.addInteger("shoulder", found.shoulder);
    branch.addInteger("elbow", found.elbow);
    branch.addInteger("wrist", found.wrist);
    object.addObject("branch", branch);
  } else {
    object.addNull("branch");
  }
  object.addBool("within_limits", isWithin(arm.model, found.q_rad));
  if (found.family != nullptr) {
    object.addText("family", found.family);
  } else {
    object.addNull("family");
  }
  return object;
}

/// The method; or a sentence, if the arm does not allow the requested one.
Result<std::string> methodFor(const ArmChoice& arm, const std::string& asked) {
  if (asked == "iterative") return asked;
  if (arm.omni && asked == "auto") return std::string("straight_line");
  if (arm.closed) return std::string("closed_form");
  if (asked == "auto") return std::string("iterative");
  return Problems{
      {"The arm has no closed form: its last three axes do not intersect in a point, or axes 2 and 3 are not parallel. "
       "Use --method iterative.",
       {}}};
}

Exit solvePoses(const InverseOptions& options, const Streams& streams) {
  const Result<ArmChoice> choice = chooseArm(options.arm);
  if (!choice) return refuseArm(choice.problems(), streams.err);
  const ArmChoice& arm = choice.value();
  const Result<std::string> method = methodFor(arm, options.method);
  if (!method) return fail(method.problems(), Exit::Usage, streams);
  return answerLines(streams, [&](std::string_view text) -> Result<JsonObject> {
    const Result<json::Value> line = readLine(text, {"X_WT"}, "{\"X_WT\": 4x4 in mm}");
    if (!line) return line.problems();
    const Result<Pose> X_WT = readPose(line.value(), "X_WT");
    if (!X_WT) return X_WT.problems();
    const Answer answer = method.value() == "straight_line" ? byStraightLine(arm, X_WT.value())
                          : method.value() == "closed_form" ? byClosedForm(arm, X_WT.value())
                                                            : byIteration(arm, X_WT.value(), options.seed);
    std::vector<JsonObject> solutions;
    for (const Found& found : answer.found) solutions.push_back(solutionObject(arm, found));
    JsonObject object;
    object.addBool("reachable", answer.reachable);
    object.addBool("singular", answer.singular);
    object.addList("solutions", solutions);
    return object;
  });
}

}  // namespace

void addInverse(Command program, const Streams& streams, Exit& exit) {
  const Command command =
      program.add("ik", "Inverse kinematics: the joint angles for a pose of the stylus, line by line");
  const auto options = std::make_shared<InverseOptions>();
  addArmOption(command, options->arm);
  command.option("--method", options->method, "auto: in closed form if the arm has one; iterative: one solution")
      .showUsual()
      .oneOf({"auto", "closed_form", "iterative"});
  command.option("--seed", options->seed, "Seed of the iteration's restarts").showUsual();
  command.footer(
      "Each line in is {\"X_WT\": 4x4 in mm}; each line out is {\"reachable\", \"singular\", \"solutions\": "
      "[{\"q_rad\",\n"
      "\"branch\": {\"shoulder\", \"elbow\", \"wrist\"}, \"within_limits\", \"family\"}]}, or {\"error\", \"line\"}.\n"
      "family: null, or \"q1 free\", \"q4+q6\", \"q6-q4\" for one of infinitely many solutions.\n"
      "\n" +
      listOfArms());
  command.whenChosen([options, &streams, &exit] { exit = solvePoses(*options, streams); });
}

}  // namespace underact::cli
