#include "core/manipulator/follow.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/base/units.h"
#include "core/base/valid_bytes.h"
#include "core/manipulator/closed_form.h"
#include "core/manipulator/global.h"
#include "core/manipulator/thesis_law.h"

namespace underact::manipulator {
namespace {

constexpr int kTicksAStep = 4;       // the pace of the second descent: a quarter of a step each tick
constexpr int kStepsAStart = 25;     // then another start is tried
constexpr double kSamePlace = 1e-4;  // of the reach
constexpr double kStanding = 1e3;    // of the tolerance
constexpr double kFurthest = 0.02;   // rad or shares of the reach, a tick

Values drawn(const Manipulator& m, std::uint64_t& random) noexcept UNDERACT_REAL_TIME {
  Values theta{};
  for (std::size_t i = 0; i < std::min(m.chain.joints.size(), kMaxJoints); ++i) {
    theta[i] = valueAt(m.chain.joints[i], nextShare(random), m.reach_m);
  }
  return theta;
}

/// A step of the second descent. Gives what its minimum saves against `now`, 0 where nothing (yet).
double searchStep(const Manipulator& m, const Pose& X_WT, const Energy& now,
                  BackgroundSearch& background) noexcept UNDERACT_REAL_TIME {
  if (!background.begun) {
    background.theta = drawn(m, background.random);
    background.steps = 0;
    background.begun = true;
  }
  Energy at;
  evaluate(m, X_WT, background.theta, at);
  const Descent descent = descend(m, X_WT, 1, at);
  background.theta = clampedToLimits(m, at.theta);
  const double saves_J = now.energy_J - at.energy_J;
  const bool elsewhere = (at.tip.X_WT.translation() - now.tip.X_WT.translation()).norm() > kSamePlace * m.reach_m ||
                         (at.e_o_W - now.e_o_W).norm() > kSamePlace;
  if (elsewhere && saves_J > kBetter_J && saves_J > kBetterShare * now.energy_J) return saves_J;
  if (descent.steps == 0 || ++background.steps >= kStepsAStart) background.begun = false;  // this start is no better
  return 0.0;
}

/// Searches for a better minimum and goes over to it; at: there, from then on.
void searchInBackground(const Manipulator& m, const Pose& X_WT, double dt_s, State& state,
                        Followed& followed) noexcept UNDERACT_REAL_TIME {
  BackgroundSearch& background = state.background;
  if (followed.at.energy_J <= kBetter_J) {  // none can be better by the margin
    background.better_s = 0.0;
    background.begun = false;
    return;
  }
  const bool known = background.better_s > 0.0;
  if (known || ++background.ticks >= kTicksAStep) {
    background.ticks = 0;
    followed.better_J = searchStep(m, X_WT, followed.at, background);
    if (followed.better_J > 0.0) {
      background.better_s += std::max(dt_s, 1e-9);
    } else {
      background.better_s = 0.0;
    }
  }
  if (background.better_s < kBetterFor_s) return;
  evaluate(m, X_WT, background.theta, followed.at);
  const Descent descent = descend(m, X_WT, m.options.max_steps - followed.steps, followed.at);
  followed.steps += descent.steps;
  followed.left = descent.left;
  background.better_s = 0.0;
  background.begun = false;
}

/// Moves the target from the last one at a limited speed.
void slew(const Vec3& p_WV, double dt_s, const State& state, Followed& followed) noexcept UNDERACT_REAL_TIME {
  followed.p_WP = p_WV;
  if (!state.begun || !(dt_s > 0.0)) return;
  const Vec3 offset_W = p_WV - state.p_WP;
  const double far_m = offset_W.norm(), allowed_m = kSlew_m_per_s * dt_s;
  if (far_m <= allowed_m) return;
  followed.p_WP = state.p_WP + (allowed_m / far_m) * offset_W;
  followed.slewing = true;
}

/// The thesis's law: the joint nearest to the stylus's position, whatever its orientation.
void byThesis(const Manipulator& m, const Pose& X_WT, Followed& followed) noexcept UNDERACT_REAL_TIME {
  const ThesisPull pull = thesisPull(m, X_WT);
  evaluate(m, X_WT, {pull.theta_rad}, followed.at);
  followed.is_unique = pull.is_unique;
  followed.p_WP = pull.p_WP;
  followed.f_along_T_W = pull.f_along_T_W;
  followed.moment_W = pull.moment_W;
}

/// The joints extrapolated by their last motion, which is mostly within one step of the minimum instead of two.
/// Unchanged where they rest to within the tolerance, or move so fast that it could be another minimum.
Values extrapolated(const Manipulator& m, const State& state) noexcept UNDERACT_REAL_TIME {
  Values theta = state.theta;
  for (std::size_t i = 0; i < std::min(m.chain.joints.size(), kMaxJoints); ++i) {
    const double unit = m.chain.joints[i].type == chain::JointType::Revolute ? 1.0 : m.reach_m;
    const double far = std::abs(state.pace[i]);
    if (far > kStanding * m.options.tolerance * unit && far < kFurthest * unit) theta[i] += state.pace[i];
  }
  return clampedToLimits(m, theta);
}

void solve(const Manipulator& m, const Pose& X_WT, const State& state, Followed& followed) noexcept UNDERACT_REAL_TIME {
  if (m.closed) {
    const Closed closed = closedForm(m, X_WT, state.begun ? state.theta : clampedToLimits(m, {}));
    evaluate(m, X_WT, closed.theta, followed.at);
    followed.is_unique = closed.is_unique || state.begun;  // with a past, the last configuration is kept
    return;
  }
  evaluate(m, X_WT, state.begun ? extrapolated(m, state) : clampedToLimits(m, {}), followed.at);
  const Descent descent = descend(m, X_WT, m.options.max_steps, followed.at);
  followed.steps = descent.steps;
  followed.left = descent.left;
}

bool isFinite(const Pose& X_WT) noexcept UNDERACT_REAL_TIME {
  double nothing = 0.0;  // 0 times a finite number is 0
  for (Eigen::Index column = 0; column < 4; ++column) {
    for (Eigen::Index row = 0; row < 3; ++row) nothing += 0.0 * X_WT.matrix()(row, column);
  }
  return nothing == 0.0;
}

}  // namespace

bool isValid(const State& state) noexcept {
  const BackgroundSearch& background = state.background;
  return isFlag(state.begun) && isFlag(state.lost) && isFlag(background.begun) && background.steps >= 0 &&
         background.steps <= kStepsAStart && background.ticks >= 0 && background.ticks <= kTicksAStep;
}

Followed follow(const Manipulator& m, const Pose& X_WT, double dt_s, State& state) noexcept {
  Followed followed;
  if (!isFinite(X_WT)) {
    evaluate(m, X_WT, state.begun ? state.theta : clampedToLimits(m, {}), followed.at);
    followed.is_unique = false;
    followed.p_WP = X_WT.translation();
    return followed;
  }
  const bool by_thesis = m.law == ForceLaw::Thesis52;
  if (by_thesis) {
    byThesis(m, X_WT, followed);
  } else {
    solve(m, X_WT, state, followed);
  }
  if (!followed.is_unique || state.lost) {
    followed.is_unique = false;
    followed.p_WP = X_WT.translation();
    followed.f_along_T_W.setZero();
    followed.moment_W.setZero();
    state.begun = false;
    return followed;
  }
  if (!by_thesis && !m.closed && state.begun) searchInBackground(m, X_WT, dt_s, state, followed);
  if (!by_thesis) followed.moment_W = followed.at.m_W;
  slew(by_thesis ? followed.p_WP : Vec3(followed.at.tip.X_WT.translation()), dt_s, state, followed);
  const Values theta = clampedToLimits(m, followed.at.theta);
  for (std::size_t i = 0; i < theta.size(); ++i) state.pace[i] = state.begun ? theta[i] - state.theta[i] : 0.0;
  state.theta = theta;
  state.p_WP = followed.p_WP;
  state.begun = true;
  return followed;
}

State settledState(const Manipulator& m, const Pose& X_WT, int& steps) {
  State state;
  steps = 0;
  if (m.law == ForceLaw::Thesis52) return state;  // it has no choice of minima
  const Global global = minEnergy(m, X_WT);
  state.theta = global.at.theta;
  state.p_WP = global.at.tip.X_WT.translation();
  state.begun = global.is_unique;
  state.lost = !global.is_unique;
  steps = global.steps;
  return state;
}

}  // namespace underact::manipulator
