#include "core/chain/numeric_inverse.h"

#include <algorithm>
#include <cmath>

#include "core/base/axis_geometry.h"
#include "core/base/random.h"
#include "core/base/rotation.h"
#include "core/base/units.h"
#include "core/chain/normal_equations.h"

namespace underact::chain {
namespace {

constexpr double kFirstDamping = 0.01;  // of the squared residual; measured: from 1e-4 to 1 the steps change by a tenth
constexpr double kMinDamping = 1e-8, kMaxDamping = 1e8;
constexpr double kDampingFloor = 1e-14;  // of the squared length: keeps pivots positive at singularities
constexpr double kDeadEnd = 1e-10;       // a step whose predicted gain is below this share of the squared residual

double draw(std::uint64_t& state, double low, double high) noexcept UNDERACT_REAL_TIME {
  return low + (high - low) * nextShare(state);
}

/// The state of one start: joints, residual, and the Jacobian there, with rotations scaled to a length.
struct Place {
  JointValues q{};
  double residual_m = kInfinity;
  double residual_rad = kInfinity;
  Residual e = Residual::Zero();
  double squared = kInfinity;  // |e|^2
  Jacobian J;
};

class Search {
 public:
  Search(const Chain& chain, const Pose& X_WT, const NumericOptions& options) noexcept UNDERACT_REAL_TIME
      : chain_(chain),
        X_WT_(X_WT),
        options_(options),
        joints_(std::min(chain.joints.size(), kMaxJoints)),
        reach_m_(reachOf(chain)),
        random_(options.seed) {
    const double wanted_m = options.rotation_length_m;
    rows_ = wanted_m == 0.0 ? 3 : 6;
    length_m_ = wanted_m > 0.0 ? wanted_m : (reach_m_ > 0.0 ? reach_m_ : 1.0);
  }

  bool reached(const Place& at) const noexcept UNDERACT_REAL_TIME {
    return at.residual_m <= options_.tolerance_m && (rows_ == 3 || at.residual_rad <= options_.tolerance_rad);
  }

  void measure(Place& at) const noexcept UNDERACT_REAL_TIME {
    const Kinematics now = kinematics(chain_, std::span<const double>(at.q).first(joints_));
    const Vec3 offset_W = X_WT_.translation() - now.X_WT.translation();
    const Vec3 turn_W = rotationVector(X_WT_.linear() * now.X_WT.linear().transpose());
    at.residual_m = offset_W.norm();
    at.residual_rad = turn_W.norm();
    at.e << offset_W, (rows_ == 6 ? length_m_ : 0.0) * turn_W;
    at.squared = at.e.squaredNorm();
    at.J = now.J;
    at.J.bottomRows<3>() *= length_m_;
  }

  /// Descends from `at` to a solution, a local minimum, or the last step.
  void descend(Place& at, int& steps) const noexcept UNDERACT_REAL_TIME {
    double damping = kFirstDamping;
    JointStep dq;
    Place next;
    for (int i = 0; i < options_.max_steps && !reached(at); ++i, ++steps) {
      const double scale = length_m_ * length_m_;
      const double damped = damping * at.squared + kDampingFloor * scale;
      const bool solved = dampedStep(at.J, at.e, rows_, damped, heldAt(at), dq);
      next.q = at.q;
      double promised = 0.0;
      if (solved) promised = stepTo(at, dq, next);
      if (solved && !(promised > kDeadEnd * at.squared)) return;
      if (solved) measure(next);
      const double gained = solved ? at.squared - next.squared : -1.0;
      if (gained > 0.0) at = next;
      // Where the prediction holds, damp less; where it does not, damp more.
      if (gained > 0.75 * promised) damping = std::max(kMinDamping, 0.1 * damping);
      if (!(gained > 0.25 * promised)) damping = 8.0 * std::max(damping, 1e-3);
      if (!(damping <= kMaxDamping)) return;
    }
  }

  Place start(std::span<const double> q_start) const noexcept UNDERACT_REAL_TIME {
    Place at;
    for (std::size_t i = 0; i < std::min(joints_, q_start.size()); ++i) at.q[i] = held(i, q_start[i]);
    return at;
  }

  Place randomStart() noexcept UNDERACT_REAL_TIME {
    Place at;
    at.q = drawnJoints(chain_, random_);
    for (std::size_t i = 0; i < joints_; ++i) at.q[i] = held(i, at.q[i]);
    return at;
  }

  void wrap(JointValues& q) const noexcept UNDERACT_REAL_TIME {
    if (options_.within_limits) return;
    for (std::size_t i = 0; i < joints_; ++i) {
      if (chain_.joints[i].type != JointType::Revolute || !(std::abs(q[i]) > kPi)) continue;
      q[i] = wrapped(q[i]);
      if (q[i] <= -kPi) q[i] = kPi;
    }
  }

 private:
  double held(std::size_t i, double value) const noexcept UNDERACT_REAL_TIME {
    return options_.within_limits ? std::clamp(value, chain_.joints[i].min, chain_.joints[i].max) : value;
  }

  /// A bit for each joint that is at a limit and would be driven beyond it.
  std::uint32_t heldAt(const Place& at) const noexcept UNDERACT_REAL_TIME {
    std::uint32_t bits = 0;
    if (!options_.within_limits) return bits;
    for (std::size_t i = 0; i < joints_; ++i) {
      const double pull = at.J.col(static_cast<Eigen::Index>(i)).dot(at.e);
      const bool out = pull < 0.0 ? at.q[i] <= chain_.joints[i].min : at.q[i] >= chain_.joints[i].max;
      if (out) bits |= 1U << static_cast<unsigned>(i);
    }
    return bits;
  }

  /// next.q: the step, clamped to the limits. Gives the gain that the linear model predicts for it.
  double stepTo(const Place& at, const JointStep& dq, Place& next) const noexcept UNDERACT_REAL_TIME {
    Residual left = at.e;
    for (std::size_t i = 0; i < joints_; ++i) {
      const Eigen::Index column = static_cast<Eigen::Index>(i);
      next.q[i] = held(i, at.q[i] + dq[column]);
      left -= (next.q[i] - at.q[i]) * at.J.col(column);
    }
    if (rows_ == 3) left.tail<3>().setZero();
    return at.squared - left.squaredNorm();
  }

  const Chain& chain_;
  const Pose& X_WT_;
  const NumericOptions& options_;
  std::size_t joints_;
  double reach_m_;
  double length_m_ = 1.0;
  std::size_t rows_ = 6;
  std::uint64_t random_;
};

}  // namespace

JointValues drawnJoints(const Chain& chain, std::uint64_t& random) noexcept {
  JointValues q{};
  const double reach_m = reachOf(chain);
  for (std::size_t i = 0; i < std::min(chain.joints.size(), kMaxJoints); ++i) {
    const Joint& joint = chain.joints[i];
    const double span = joint.type == JointType::Revolute ? kPi : reach_m;
    const bool bounded = joint.max - joint.min < kInfinity;
    q[i] = bounded ? draw(random, joint.min, joint.max) : draw(random, -span, span);
  }
  return q;
}

NumericSolution solveNumerically(const Chain& chain, const Pose& X_WT, std::span<const double> q_start,
                                 const NumericOptions& options) noexcept {
  Search search(chain, X_WT, options);
  NumericSolution best;
  double min = kInfinity;
  for (int turn = 0; turn <= options.restarts; ++turn) {
    Place at = turn == 0 ? search.start(q_start) : search.randomStart();
    if (turn == 0) best.q = at.q;
    search.measure(at);
    search.descend(at, best.steps);
    best.restarts_used = turn;
    if (at.squared < min) {
      min = at.squared;
      best.q = at.q;
      best.residual_m = at.residual_m;
      best.residual_rad = at.residual_rad;
    }
    if (search.reached(at)) {
      best.reached = true;
      break;
    }
  }
  search.wrap(best.q);
  return best;
}

}  // namespace underact::chain
