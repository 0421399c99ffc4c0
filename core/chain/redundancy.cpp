#include "core/chain/redundancy.h"

#include <algorithm>
#include <cmath>

#include "core/base/axis_geometry.h"
#include "core/base/determinant.h"
#include "core/base/singular_values.h"
#include "core/base/units.h"

namespace underact::chain {
namespace {

constexpr double kOnce = 1e-4;
constexpr int kPostureSteps = 100;
constexpr double kSettled = 1e-6;

double scaleOfJoint(const Chain& chain, std::size_t i, double reach_m) {
  return chain.joints[i].type == JointType::Prismatic ? reach_m : 1.0;
}

/// Whether a square J surely has no singular value below this share of the largest; asked before its singular values,
/// which take ten times as long. Its determinant is their product, and that of all but the least is at most what equal
/// ones of the same norm would give (arithmetic and geometric mean).
bool isRegular(const Eigen::MatrixXd& J, double relative) {
  constexpr double kForRounding = 2.0;
  if (J.rows() != J.cols() || J.rows() < 2) return false;
  const double others = static_cast<double>(J.rows() - 1), norm = J.norm();
  const double min = std::abs(determinantOf(J)) * std::pow(others / (norm * norm), others / 2);
  return min > kForRounding * relative * norm;
}

}  // namespace

std::vector<std::vector<double>> nullSpace(const Chain& chain, std::span<const double> q, Asks asks, double relative) {
  const double reach_m = std::max(reachOf(chain), 1e-300);
  Eigen::MatrixXd J = jacobian(chain, q);
  J.topRows(3) /= reach_m;
  for (Eigen::Index i = 0; i < J.cols(); ++i) J.col(i) *= scaleOfJoint(chain, static_cast<std::size_t>(i), reach_m);
  if (asks == Asks::Position) J = Eigen::MatrixXd(J.topRows(3));
  if (!J.allFinite() || isRegular(J, relative)) return {};
  const auto [gains, motions] = rightSingularValues(J);
  std::vector<std::vector<double>> basis;
  for (Eigen::Index i = 0; i < J.cols(); ++i) {
    const double gain = i < gains.size() ? gains[i] : 0.0;
    if (!(gain < relative * std::max(gains[0], 1e-300)) && i < gains.size()) continue;
    const Eigen::VectorXd motion = motions.col(i);
    basis.emplace_back(motion.data(), motion.data() + motion.size());
  }
  return basis;
}

std::vector<double> selfMotion(const Chain& chain, std::span<const double> q, Asks asks, double relative) {
  std::vector<std::vector<double>> basis = nullSpace(chain, q, asks, relative);
  if (basis.empty()) return {};
  std::vector<double> motion = std::move(basis.back());
  const double max =
      *std::max_element(motion.begin(), motion.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  for (double& one : motion) one /= max;
  return motion;
}

NumericSolution nearPosture(const Chain& chain, const Pose& X_WT, const NumericSolution& q,
                            std::span<const double> posture, const NumericOptions& options) {
  NumericSolution best = q;
  const std::size_t count = chain.joints.size();
  const double reach_m = std::max(reachOf(chain), 1e-300);
  const Asks asks = options.rotation_length_m == 0.0 ? Asks::Position : Asks::Pose;
  const auto offsetOf = [&](const JointValues& from, std::size_t i) {
    const double offset = posture[i] - from[i];
    const Joint& joint = chain.joints[i];
    // Within limits of less than a turn the shorter way round is barred.
    const bool is_round = !options.within_limits || joint.max - joint.min >= 2.0 * kPi;
    return (joint.type == JointType::Revolute && is_round ? wrapped(offset) : offset) / scaleOfJoint(chain, i, reach_m);
  };
  const auto squaredOf = [&](const JointValues& from) {
    double squared = 0.0;
    for (std::size_t i = 0; i < count; ++i) squared += offsetOf(from, i) * offsetOf(from, i);
    return squared;
  };
  if (!q.reached || posture.size() != count) return best;
  NumericOptions again = options;
  again.restarts = 0;
  double share = 1.0;
  for (int step = 0; step < kPostureSteps && share > 1e-3; ++step) {
    const std::vector<std::vector<double>> basis = nullSpace(chain, std::span(best.q).first(count), asks, 1e-6);
    JointValues next = best.q;
    double far = 0.0;
    for (const std::vector<double>& motion : basis) {
      double along = 0.0;
      for (std::size_t i = 0; i < count; ++i) along += motion[i] * offsetOf(best.q, i);
      for (std::size_t i = 0; i < count; ++i) next[i] += share * along * motion[i] * scaleOfJoint(chain, i, reach_m);
      far = std::max(far, std::abs(along));
    }
    if (!(far > kSettled)) break;
    const NumericSolution moved = solveNumerically(chain, X_WT, std::span(next).first(count), again);
    if (moved.reached && squaredOf(moved.q) < squaredOf(best.q)) {
      best.q = moved.q;
      best.residual_m = moved.residual_m, best.residual_rad = moved.residual_rad;
      share = std::min(1.0, 2.0 * share);
    } else {
      share *= 0.5;
    }
    best.steps += moved.steps;
  }
  return best;
}

std::vector<NumericSolution> searchAll(const Chain& chain, const Pose& X_WT, std::span<const double> q_start,
                                       const NumericOptions& options, int starts) {
  std::vector<NumericSolution> found;
  const double reach_m = std::max(reachOf(chain), 1e-300);
  NumericOptions once = options;
  once.restarts = 0;
  std::uint64_t random = options.seed;
  for (int start = 0; start < starts; ++start) {
    const JointValues drawn = start == 0 ? JointValues{} : drawnJoints(chain, random);
    const std::span<const double> from = start == 0 ? q_start : std::span(drawn).first(chain.joints.size());
    const NumericSolution one = solveNumerically(chain, X_WT, from, once);
    if (!one.reached) continue;
    const bool is_new = std::none_of(found.begin(), found.end(), [&](const NumericSolution& other) {
      return areSame(chain, one.q, other.q, reach_m, kOnce);
    });
    if (is_new) found.push_back(one);
  }
  return found;
}

}  // namespace underact::chain
