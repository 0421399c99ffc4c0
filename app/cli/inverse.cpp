#include "core/kinematics/inverse.h"

#include <cstddef>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "app/cli/arm_choice.h"
#include "app/cli/json_lines.h"
#include "app/cli/scene_file.h"

namespace underact::cli {
namespace {

using kinematics::SolvedArm;

/// As they are asked for; posture: the text of --prefer.
struct AskedPoses : kinematics::InverseOptions {
  AskedArm arm;
  std::string prefer;
};

JsonObject solutionObject(const SolvedArm& arm, const kinematics::Found& found) {
  JsonObject object;
  object.addList("q_rad", jointNumbers(arm.chain(), found.q));
  if (found.branch[0].name != nullptr) {
    JsonObject branch;
    for (const chain::BranchName& one : found.branch) {
      if (one.name != nullptr) branch.addInteger(one.name, one.choice);
    }
    object.addObject("branch", branch);
  } else {
    object.addNull("branch");
  }
  object.addBool("within_limits", found.within_limits);
  if (!found.family.empty()) {
    object.addText("family", found.family);
  } else {
    object.addNull("family");
  }
  if (kinematics::hasSurplus(arm)) {
    Eigen::MatrixXd basis(static_cast<Eigen::Index>(found.null_space.size()), static_cast<Eigen::Index>(arm.joints()));
    for (Eigen::Index i = 0; i < basis.rows(); ++i) {
      basis.row(i) =
          Eigen::Map<const Eigen::RowVectorXd>(found.null_space[static_cast<std::size_t>(i)].data(), basis.cols());
    }
    object.addMatrix("null_space", basis);
  }
  return object;
}

/// --prefer: one entry for each joint; empty: none.
Result<std::vector<double>> postureOf(const SolvedArm& arm, const std::string& text) {
  if (text.empty()) return std::vector<double>{};
  const Result<json::Value> line = readLine("{\"prefer\": " + text + "}", {"prefer"}, "{\"prefer\": [q1, ...]}");
  if (!line) return line.problems();
  const Result<chain::JointValues> q = readJoints(line.value(), "prefer", arm.chain());
  if (!q) return q.problems();
  const auto begin = q.value().begin();
  return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(arm.joints()));
}

Exit solvePoses(const AskedPoses& options, const Streams& streams) {
  const Result<SolvedArm> choice = askedArm(options.arm, streams.err);
  if (!choice) return refuseArm(choice.problems(), streams.err);
  const SolvedArm& arm = choice.value();
  const Result<kinematics::Method> method = kinematics::methodFor(arm, options.method);
  if (!method) return fail(method.problems(), Exit::Usage, streams);
  const Result<std::vector<double>> posture = postureOf(arm, options.prefer);
  if (!posture) return fail(posture.problems(), Exit::Usage, streams);
  kinematics::InverseOptions asked = options;
  asked.posture = posture.value();
  return answerLines(streams, [&](std::string_view text) -> Result<JsonObject> {
    const Result<json::Value> line = readLine(text, {"X_WT"}, "{\"X_WT\": 4x4 in mm}");
    if (!line) return line.problems();
    std::string note;
    const Result<Pose> X_WT = readPose(line.value(), "X_WT", &note);
    if (!X_WT) return X_WT.problems();
    if (!note.empty()) streams.err << "note: " << note << '\n';
    const kinematics::Answer answer = kinematics::solve(arm, X_WT.value(), method.value(), asked);
    std::vector<JsonObject> solutions;
    for (const kinematics::Found& found : answer.found) solutions.push_back(solutionObject(arm, found));
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
  const auto options = std::make_shared<AskedPoses>();
  addArmOption(command, options->arm);
  command.option("--method", options->method, "auto: in closed form if the arm has one; iterative: one solution")
      .showDefault()
      .oneOf({"auto", "closed_form", "iterative"});
  command.option("--seed", options->seed, "Seed of the iteration's restarts").showDefault();
  command
      .option("--search", options->search,
              "Of the iteration: all different solutions that this many starts find; 0: the first one of up to 101")
      .range(0, 100000)
      .showDefault();
  command.option(
      "--prefer", options->prefer,
      "A posture, [q1, ...]: full turns are those nearest to it, the solution nearest to it comes first, and the "
      "iteration starts from it and comes near to it where the arm has joints to spare");
  command.footer(
      "Each line in is {\"X_WT\": 4x4 in mm}; each line out is {\"reachable\", \"singular\", \"solutions\": "
      "[{\"q_rad\",\n"
      "\"branch\": {\"shoulder\", \"elbow\", \"wrist\"}, \"within_limits\", \"family\"}]}, or {\"error\", \"line\"}.\n"
      "family: null, or \"q1 free\", \"q4+q6\", \"q6-q4\" for one of infinitely many solutions. q_rad has one entry "
      "for "
      "each\njoint, mm where it slides. branch is null where the arm has no closed form; an arm with joints to spare "
      "adds\n"
      "\"null_space\". Of up to three joints that do not move in a plane, only the position is asked for.\n"
      "\n" +
      listOfArms());
  command.whenChosen([options, &streams, &exit] { exit = solvePoses(*options, streams); });
}

}  // namespace underact::cli
