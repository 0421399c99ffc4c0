#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "app/cli/arm_choice.h"
#include "app/cli/json_lines.h"
#include "app/cli/scene_file.h"
#include "core/arm/branches.h"
#include "core/base/units.h"
#include "core/chain/closed_form.h"
#include "core/chain/numeric_inverse.h"
#include "core/chain/redundancy.h"

namespace underact::cli {
namespace {

struct InverseOptions {
  std::string arm;
  std::string method = "auto";
  std::uint64_t seed = 1;
  int search = 0;
  std::string prefer;
};

/// One solution, however it was found.
struct Found {
  chain::JointValues q{};
  std::string family;  // empty: isolated
  std::array<chain::BranchName, 3> branch{};
  std::vector<std::vector<double>> null_space;  // of an arm with more joints than the pose needs
};

struct Answer {
  bool reachable = false;
  bool singular = false;
  std::vector<Found> found;
};

std::array<chain::BranchName, 3> branchOf(int shoulder, int elbow, int wrist) {
  return {{{"shoulder", shoulder}, {"elbow", elbow}, {"wrist", wrist}}};
}

Answer byStraightLine(const ArmChoice& arm, const Pose& X_WT) {
  const arm::Solutions solutions = arm::solveAll(*arm.omni, arm::limitsOf(arm.model), X_WT);
  Answer answer{solutions.reachable, solutions.singular(), {}};
  for (const arm::Solution& one : solutions) {
    Found found;
    std::copy(one.q_rad.begin(), one.q_rad.end(), found.q.begin());
    if (one.family != arm::Family::None) found.family = name(one.family);
    found.branch = branchOf(one.branch.shoulder, one.branch.elbow, one.branch.wrist);
    answer.found.push_back(found);
  }
  return answer;
}

/// The names of the free families of an arm whose wrist axes are aligned, |sin| of its bend being small.
const char* wristFamily(const ArmChoice& arm, std::span<const double> q_rad) {
  const chain::Jacobian J = chain::jacobian(arm.flange, q_rad);
  const Vec3 four_W = J.col(3).tail<3>(), six_W = J.col(5).tail<3>();
  if (four_W.cross(six_W).norm() >= arm::kSingularSine) return "";
  return four_W.dot(six_W) > 0.0 ? "q4+q6" : "q6-q4";
}

Answer byClosedForm(const ArmChoice& arm, const Pose& X_WT) {
  const chain::Solutions solutions = chain::solveAll(*arm.closed, X_WT);
  Answer answer{solutions.exact > 0, false, {}};
  const double reach_m = chain::reachOf(arm.flange);
  for (std::size_t index = 0; index < solutions.exact; ++index) {
    const chain::Solution& one = solutions.all[index];
    Found found;
    std::copy(one.q.begin(), one.q.end(), found.q.begin());
    found.family = wristFamily(arm, one.q);
    found.branch = branchOf(one.shoulder, one.elbow, one.wrist);
    const Mat3 Jp = chain::jacobian(arm.flange, one.q).topLeftCorner<3, 3>();
    const bool placed = std::abs(Jp.determinant()) < arm::kSingularSine * reach_m * reach_m * reach_m;
    answer.singular |= placed || !found.family.empty();
    answer.found.push_back(found);
  }
  return answer;
}

/// The joints of a self-motion, as a family is called: "q1 free", "q4+q6" where their sum stays, "q6-q4" where their
/// difference does, else the joints that move together.
std::string familyOf(const std::vector<double>& motion) {
  constexpr double kTakesPart = 1e-4;
  std::vector<std::size_t> moved;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    if (std::abs(motion[i]) > kTakesPart) moved.push_back(i);
  }
  const auto joint = [&](std::size_t i) { return "q" + std::to_string(moved[i] + 1); };
  if (moved.empty()) return {};
  if (moved.size() == 1) return joint(0) + " free";
  const double sum = moved.size() == 2 ? motion[moved[0]] + motion[moved[1]] : kInfinity;
  const double difference = moved.size() == 2 ? motion[moved[0]] - motion[moved[1]] : kInfinity;
  if (std::abs(sum) < kTakesPart) return joint(0) + "+" + joint(1);
  if (std::abs(difference) < kTakesPart) return joint(1) + "-" + joint(0);
  std::string all;
  for (std::size_t i = 0; i < moved.size(); ++i) all += (i == 0 ? "" : ", ") + joint(i);
  return all + " together";
}

/// A joint more than the tip needs is no singularity, but a null space.
bool hasSurplus(const ArmChoice& arm) {
  return arm.joints() > (arm.inverse.asks == chain::Asks::Pose ? 6U : 3U);
}

void addSelfMotion(const ArmChoice& arm, Found& found, Answer& answer) {
  const std::span<const double> q = std::span(found.q).first(arm.joints());
  if (hasSurplus(arm)) {
    found.null_space = chain::nullSpace(arm.chain(), q, arm.inverse.asks, arm::kSingularSine);
  } else {
    found.family = familyOf(chain::selfMotion(arm.chain(), q, arm.inverse.asks, arm::kSingularSine));
    answer.singular |= !found.family.empty();
  }
}

Answer byGeometry(const ArmChoice& arm, const Pose& X_WT) {
  const chain::InverseSolutions solutions = chain::solveAll(arm.inverse, X_WT);
  Answer answer{solutions.count > 0, false, {}};
  for (std::size_t i = 0; i < solutions.count; ++i) {
    Found found;
    found.q = solutions.all[i].q;
    found.branch = solutions.all[i].branch;
    addSelfMotion(arm, found, answer);
    answer.found.push_back(found);
  }
  return answer;
}

Answer byIteration(const ArmChoice& arm, const Pose& X_WT, const InverseOptions& asked,
                   const std::vector<double>& posture) {
  chain::NumericOptions options;
  options.seed = asked.seed;
  if (arm.inverse.asks == chain::Asks::Position) options.rotation_length_m = 0.0;
  const chain::JointValues home{};
  const std::span<const double> start =
      posture.empty() ? std::span<const double>(home).first(arm.joints()) : std::span<const double>(posture);
  std::vector<chain::NumericSolution> all;
  if (asked.search > 0) {
    all = chain::searchAll(arm.chain(), X_WT, start, options, asked.search);
  } else {
    options.restarts = 50;
    const chain::NumericSolution one = chain::solveNumerically(arm.chain(), X_WT, start, options);
    if (one.reached) all.push_back(one);
  }
  Answer answer{!all.empty(), false, {}};
  for (const chain::NumericSolution& one : all) {
    Found found;
    found.q = posture.empty() ? one.q : chain::nearPosture(arm.chain(), X_WT, one, posture, options).q;
    if (arm.joints() != 6) addSelfMotion(arm, found, answer);  // of six joints, as it always was: nothing is said
    answer.found.push_back(found);
  }
  return answer;
}

JsonObject solutionObject(const ArmChoice& arm, const Found& found) {
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
  object.addBool("within_limits", arm::isWithinLimits(arm.model, std::span(found.q).first(arm.joints())));
  if (!found.family.empty()) {
    object.addText("family", found.family);
  } else {
    object.addNull("family");
  }
  if (hasSurplus(arm)) {
    Eigen::MatrixXd basis(static_cast<Eigen::Index>(found.null_space.size()), static_cast<Eigen::Index>(arm.joints()));
    for (Eigen::Index i = 0; i < basis.rows(); ++i) {
      basis.row(i) =
          Eigen::Map<const Eigen::RowVectorXd>(found.null_space[static_cast<std::size_t>(i)].data(), basis.cols());
    }
    object.addMatrix("null_space", basis);
  }
  return object;
}

/// The method; or a sentence, if the arm does not allow the requested one.
Result<std::string> methodFor(const ArmChoice& arm, const InverseOptions& options) {
  if (options.method == "iterative") return options.method;
  if (arm.omni && options.method == "auto") return std::string("straight_line");
  if (arm.closed) return std::string("closed_form");
  if (arm.inverse.isClosed()) return std::string("geometry");
  if (options.method == "auto") return std::string("iterative");
  return Problems{
      {"The arm has no closed form: no three neighbouring axes at either end intersect in a point, axes 2, 3 and 4 (or "
       "3, "
       "4 and 5) are not parallel, and its joints do not move in a plane. Use --method iterative.",
       {}}};
}

/// --prefer: one entry for each joint; empty: none.
Result<std::vector<double>> postureOf(const ArmChoice& arm, const std::string& text) {
  if (text.empty()) return std::vector<double>{};
  const Result<json::Value> line = readLine("{\"prefer\": " + text + "}", {"prefer"}, "{\"prefer\": [q1, ...]}");
  if (!line) return line.problems();
  const Result<chain::JointValues> q = readJoints(line.value(), "prefer", arm.chain());
  if (!q) return q.problems();
  const auto begin = q.value().begin();
  return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(arm.joints()));
}

Exit solvePoses(const InverseOptions& options, const Streams& streams) {
  const Result<ArmChoice> choice = chooseArm(options.arm);
  if (!choice) return refuseArm(choice.problems(), streams.err);
  const ArmChoice& arm = choice.value();
  const Result<std::string> method = methodFor(arm, options);
  if (!method) return fail(method.problems(), Exit::Usage, streams);
  const Result<std::vector<double>> posture = postureOf(arm, options.prefer);
  if (!posture) return fail(posture.problems(), Exit::Usage, streams);
  return answerLines(streams, [&](std::string_view text) -> Result<JsonObject> {
    const Result<json::Value> line = readLine(text, {"X_WT"}, "{\"X_WT\": 4x4 in mm}");
    if (!line) return line.problems();
    const Result<Pose> X_WT = readPose(line.value(), "X_WT");
    if (!X_WT) return X_WT.problems();
    const Answer answer = method.value() == "straight_line" ? byStraightLine(arm, X_WT.value())
                          : method.value() == "closed_form" ? byClosedForm(arm, X_WT.value())
                          : method.value() == "geometry"    ? byGeometry(arm, X_WT.value())
                                                            : byIteration(arm, X_WT.value(), options, posture.value());
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
  command
      .option("--search", options->search,
              "Of the iteration: all different solutions that this many starts find; 0: the first one of up to 51")
      .range(0, 100000)
      .showUsual();
  command.option(
      "--prefer", options->prefer,
      "Of the iteration: a posture, [q1, ...], to start from and to come near to where the arm has joints to "
      "spare");
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
