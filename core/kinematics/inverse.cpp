#include "core/kinematics/inverse.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/arm/branches.h"
#include "core/chain/closed_form.h"
#include "core/chain/numeric_inverse.h"
#include "core/chain/redundancy.h"
#include "core/kinematics/units.h"

namespace underact::kinematics {
namespace {

std::array<chain::BranchName, 3> branchOf(int shoulder, int elbow, int wrist) {
  return {{{"shoulder", shoulder}, {"elbow", elbow}, {"wrist", wrist}}};
}

Answer byStraightLine(const SolvedArm& arm, const Pose& X_WT) {
  const arm::Solutions solutions = arm::solveAll(*arm.omni, arm::limitsOf(arm.model), X_WT);
  Answer answer{solutions.reachable,   solutions.singular(), {},
                solutions.at_shoulder, solutions.at_elbow,   solutions.at_wrist};
  answer.found.reserve(solutions.count);
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
const char* wristFamily(const SolvedArm& arm, std::span<const double> q_rad) {
  const chain::Jacobian J = chain::jacobian(arm.flange, q_rad);
  const Vec3 four_W = J.col(3).tail<3>(), six_W = J.col(5).tail<3>();
  if (four_W.cross(six_W).norm() >= arm::kSingularSine) return "";
  return four_W.dot(six_W) > 0.0 ? "q4+q6" : "q6-q4";
}

Answer byClosedForm(const SolvedArm& arm, const Pose& X_WT) {
  const chain::Solutions solutions = chain::solveAll(*arm.closed, X_WT);
  Answer answer{solutions.exact > 0, false, {}};
  answer.found.reserve(solutions.exact);
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

void addSelfMotion(const SolvedArm& arm, Found& found, Answer& answer) {
  const std::span<const double> q = std::span(found.q).first(arm.joints());
  if (hasSurplus(arm)) {
    found.null_space = chain::nullSpace(arm.chain(), q, arm.inverse.asks, arm::kSingularSine);
  } else {
    found.family = familyOf(chain::selfMotion(arm.chain(), q, arm.inverse.asks, arm::kSingularSine));
    answer.singular |= !found.family.empty();
  }
}

Answer byGeometry(const SolvedArm& arm, const Pose& X_WT) {
  const chain::InverseSolutions solutions = chain::solveAll(arm.inverse, X_WT);
  Answer answer{solutions.count > 0, false, {}};
  answer.found.reserve(solutions.count);
  for (std::size_t i = 0; i < solutions.count; ++i) {
    Found found;
    found.q = solutions.all[i].q;
    found.branch = solutions.all[i].branch;
    addSelfMotion(arm, found, answer);
    answer.found.push_back(found);
  }
  return answer;
}

/// The chain of an arm, or where the limits of joint 5 are of its size, of one with its wrist bent to either side.
chain::Chain bentEitherWay(const arm::Model& model) {
  chain::Chain chain = model.chain;
  if (model.limits_wrist_size && chain.joints.size() > 4) chain.joints[4].min = -chain.joints[4].max;
  return chain;
}

std::vector<chain::NumericSolution> searched(const chain::Chain& chain, const Pose& X_WT, std::span<const double> start,
                                             chain::NumericOptions options, int starts) {
  if (starts > 0) return chain::searchAll(chain, X_WT, start, options, starts);
  options.restarts = 100;
  const chain::NumericSolution one = chain::solveNumerically(chain, X_WT, start, options);
  if (one.reached) return {one};
  return {};
}

Answer byIteration(const SolvedArm& arm, const Pose& X_WT, const InverseOptions& asked) {
  const std::vector<double>& posture = asked.posture;
  const chain::Chain either_way = arm.model.limits_wrist_size ? bentEitherWay(arm.model) : chain::Chain{};
  const chain::Chain& chain = arm.model.limits_wrist_size ? either_way : arm.chain();
  chain::NumericOptions options;
  options.seed = asked.seed;
  options.within_limits = true;
  if (arm.inverse.asks == chain::Asks::Position) options.rotation_length_m = 0.0;
  const chain::JointValues home{};
  const std::span<const double> start =
      posture.empty() ? std::span<const double>(home).first(arm.joints()) : std::span<const double>(posture);
  std::vector<chain::NumericSolution> all = searched(chain, X_WT, start, options, asked.search);
  if (all.empty()) {
    options.within_limits = false;
    all = searched(chain, X_WT, start, options, asked.search);
  }
  Answer answer{!all.empty(), false, {}};
  for (const chain::NumericSolution& one : all) {
    Found found;
    found.q = posture.empty() ? one.q : chain::nearPosture(chain, X_WT, one, posture, options).q;
    if (arm.joints() != 6) addSelfMotion(arm, found, answer);  // of six joints, as it always was: nothing is said
    answer.found.push_back(found);
  }
  return answer;
}

Answer answerBy(const SolvedArm& arm, const Pose& X_WT, Method method, const InverseOptions& options) {
  switch (method) {
    case Method::StraightLine:
      return byStraightLine(arm, X_WT);
    case Method::ClosedForm:
      return byClosedForm(arm, X_WT);
    case Method::Geometry:
      return byGeometry(arm, X_WT);
    case Method::Iteration:
      break;
  }
  return byIteration(arm, X_WT, options);
}

/// The sum of the squared distances from a posture; slides count as shares of the reach.
double squaredFrom(const SolvedArm& arm, const std::vector<double>& posture, const chain::JointValues& q) {
  double squared = 0.0;
  for (std::size_t i = 0; i < std::min(arm.joints(), posture.size()); ++i) {
    const double offset = (q[i] - posture[i]) / (turns(arm.chain().joints[i]) ? 1.0 : arm.inverse.reach_m);
    squared += offset * offset;
  }
  return squared;
}

}  // namespace

/// A joint more than the tip needs is no singularity, but a null space.
bool hasSurplus(const SolvedArm& arm) noexcept {
  return arm.joints() > (arm.inverse.asks == chain::Asks::Pose ? 6U : 3U);
}

Result<Method> methodFor(const SolvedArm& arm, std::string_view method) {
  if (method == "iterative") return Method::Iteration;
  if (arm.omni && method == "auto") return Method::StraightLine;
  if (arm.closed) return Method::ClosedForm;
  if (arm.inverse.isClosed()) return Method::Geometry;
  if (method == "auto") return Method::Iteration;
  return Problems{
      {"The arm has no closed form: no three neighbouring axes at either end intersect in a point, axes 2, 3 and 4 (or "
       "3, "
       "4 and 5) are not parallel, and its joints do not move in a plane. Use --method iterative.",
       {}}};
}

Answer solve(const SolvedArm& arm, const Pose& X_WT, Method method, const InverseOptions& options) {
  Answer answer = answerBy(arm, X_WT, method, options);
  for (Found& one : answer.found) {
    const std::span<double> q = std::span(one.q).first(arm.joints());
    arm::turnIntoLimits(arm.model, q, options.posture);
    one.within_limits = arm::isWithinLimits(arm.model, q);
  }
  if (options.posture.empty()) return answer;
  const auto rank = [&](const Found& one) {
    return std::pair(!one.within_limits, squaredFrom(arm, options.posture, one.q));
  };
  std::stable_sort(answer.found.begin(), answer.found.end(),
                   [&](const Found& a, const Found& b) { return rank(a) < rank(b); });
  return answer;
}

}  // namespace underact::kinematics
