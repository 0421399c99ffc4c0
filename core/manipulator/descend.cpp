#include "core/manipulator/descend.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/axis_geometry.h"
#include "core/base/norms.h"

namespace underact::manipulator {
namespace {

using chain::JointType;

constexpr double kFirstDamping = 1e-3;  // of a joint's spread, after an undamped step has failed
constexpr double kMinDamping = 1e-9;    // below it there is none
constexpr double kFloor = 1e-13;        // of the spread: keeps pivots positive where the chain is singular
constexpr double kLongestTurn_rad = 0.5;
constexpr double kLongestSlide = 0.25;  // of the reach
constexpr double kRounding = 0x1p-48;   // relative to the energy and its terms: a loss within rounding

/// What is constant during a descent, and the present curvature.
class Slope {
 public:
  explicit Slope(const Manipulator& manipulator) noexcept UNDERACT_REAL_TIME
      : m_(manipulator),
        count_(std::min(manipulator.chain.joints.size(), kMaxJoints)) {}

  /// Finds the joints that a limit holds there.
  void hold(const Energy& at) noexcept UNDERACT_REAL_TIME {
    for (std::size_t i = 0; i < count_; ++i) {
      const chain::Joint& joint = m_.chain.joints[i];
      held_[i] = at.slope[i] > 0.0 ? at.theta[i] <= joint.min : at.slope[i] < 0.0 && at.theta[i] >= joint.max;
    }
  }

  /// Computes the curvature there.
  void bend(const Energy& at) noexcept UNDERACT_REAL_TIME {
    curvature(m_, at, m_.options.second_order, H_, spread_);
    double stiffest = 0.0;
    for (std::size_t i = 0; i < count_; ++i) stiffest = std::max(stiffest, spread_[i] / (unit(i) * unit(i)));
    for (std::size_t i = 0; i < count_; ++i) {
      // A joint that moves nothing has no curvature: it gets a trace of the others'.
      spread_[i] = std::max(spread_[i], 1e-12 * stiffest * unit(i) * unit(i));
    }
  }

  /// The largest step that a joint would take by itself, by the last curvature computed.
  double left(const Energy& at) const noexcept UNDERACT_REAL_TIME {
    double max = 0.0;
    for (std::size_t i = 0; i < count_; ++i) {
      if (held_[i] || at.slope[i] == 0.0) continue;
      const double curved = std::max(std::abs(H_.a[i][i]), 1e-3 * spread_[i]);
      max = std::max(max, std::abs(at.slope[i]) * unit(i) / curved);
    }
    return max;
  }

  /// Computes the damped step into next; false where the damped curvature is not positive. promised: the predicted
  /// gain.
  bool step(const Energy& at, double damping, Values& next, double& promised) const noexcept UNDERACT_REAL_TIME {
    Hessian s;
    std::array<std::size_t, kMaxJoints> joint;
    s.size = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      if (held_[i]) continue;
      for (std::size_t k = 0; k < s.size; ++k) s.a[s.size][k] = H_.a[i][joint[k]];
      s.a[s.size][s.size] = H_.a[i][i] + (damping + kFloor) * spread_[i];
      s.b[s.size] = -at.slope[i];
      joint[s.size++] = i;
    }
    if (!solveInPlace(s)) return false;
    double longest = 1.0;
    for (std::size_t k = 0; k < s.size; ++k) {
      const bool turns = m_.chain.joints[joint[k]].type == JointType::Revolute;
      longest = std::max(longest, std::abs(s.b[k]) / (turns ? kLongestTurn_rad : kLongestSlide * m_.reach_m));
    }
    Values moved{};
    for (std::size_t k = 0; k < s.size; ++k) moved[joint[k]] = s.b[k] / longest;
    for (std::size_t i = 0; i < count_; ++i) {
      next[i] = std::clamp(at.theta[i] + moved[i], m_.chain.joints[i].min, m_.chain.joints[i].max);
      moved[i] = next[i] - at.theta[i];
    }
    promised = 0.0;
    for (std::size_t i = 0; i < count_; ++i) {
      double row = 0.5 * H_.a[i][i] * moved[i];
      for (std::size_t k = 0; k < i; ++k) row += H_.a[i][k] * moved[k];
      promised -= (at.slope[i] + row) * moved[i];
    }
    return true;
  }

 private:
  double unit(std::size_t i) const noexcept UNDERACT_REAL_TIME {
    return m_.chain.joints[i].type == JointType::Revolute ? 1.0 : 1.0 / m_.reach_m;
  }

  const Manipulator& m_;
  std::size_t count_;
  Hessian H_;
  Values spread_{};
  std::array<bool, kMaxJoints> held_{};
};

/// The rounding error of the energy there: its own, and that of the positions and orientations whose difference is
/// small.
double roundingOf(const Manipulator& m, const Pose& X_WT, const Energy& at) noexcept UNDERACT_REAL_TIME {
  const double place_m = m.reach_m + largestOf(X_WT.translation());
  return kRounding * (at.energy_J + largestOf(at.f_W) * place_m + largestOf(at.m_W));
}

}  // namespace

Descent descend(const Manipulator& m, const Pose& X_WT, int max_steps, Energy& at) noexcept {
  Slope slope(m);
  Descent descent;
  double damping = 0.0, growth = 2.0;
  Energy other;
  Energy *here = &at, *next = &other;  // evaluations are large, so they are swapped
  const auto arrive = [&] {
    if (here != &at) at = *here;
    return descent;
  };
  slope.hold(*here);
  slope.bend(*here);
  descent.left = slope.left(*here);
  for (;;) {
    descent.converged = descent.left <= m.options.tolerance;
    if (descent.converged || descent.steps >= max_steps) return arrive();
    Values theta{};
    double promised = 0.0;
    // At a damping of 1 the curvature is positive: its spread outweighs the second-order terms.
    while (!slope.step(*here, damping, theta, promised)) {
      if (!(damping < 1e3)) return arrive();
      damping = damping > 0.0 ? damping * growth : kFirstDamping;
      growth *= 2.0;
    }
    ++descent.steps;
    evaluate(m, X_WT, theta, *next);
    const double gained = here->energy_J - next->energy_J, rounding_J = roundingOf(m, X_WT, *here);
    if (!(gained >= -rounding_J)) {
      damping = damping > 0.0 ? damping * growth : kFirstDamping;
      growth *= 2.0;
      if (!(damping < 1e9)) return arrive();
      continue;
    }
    const double kept = promised > 0.0 ? gained / promised : 1.0, better = 2.0 * kept - 1.0;
    damping *= std::max(1.0 / 3.0, 1.0 - better * better * better);  // Nielsen's rule
    if (damping < kMinDamping) damping = 0.0;
    growth = 2.0;
    const bool stands = gained <= rounding_J;
    const double before = descent.left;
    std::swap(here, next);
    // So close, the last curvature shows as well as a new one whether a joint still moves.
    slope.hold(*here);
    descent.left = slope.left(*here);
    if (descent.left <= m.options.tolerance || descent.steps >= max_steps) continue;
    slope.bend(*here);
    descent.left = slope.left(*here);
    // Only rounding moves it now: a tolerance below that would never be reached.
    if (stands && descent.left > 0.5 * before) return arrive();
  }
}

Values clampedToLimits(const Manipulator& m, Values theta) noexcept {
  for (std::size_t i = 0; i < std::min(m.chain.joints.size(), kMaxJoints); ++i) {
    const chain::Joint& joint = m.chain.joints[i];
    const bool free = joint.min == -kInfinity && joint.max == kInfinity && m.spring[i] == 0.0;
    if (free && joint.type == JointType::Revolute) theta[i] = wrapped(theta[i]);
    theta[i] = std::clamp(theta[i], joint.min, joint.max);
  }
  return theta;
}

double valueAt(const chain::Joint& joint, double share, double slide_m) noexcept {
  const double span = joint.type == JointType::Revolute ? kPi : slide_m;
  const double low = joint.min > -kInfinity ? joint.min : std::min(-span, joint.max - 2.0 * span);
  const double high = joint.max < kInfinity ? joint.max : std::max(span, joint.min + 2.0 * span);
  return low + share * (high - low);
}

}  // namespace underact::manipulator
