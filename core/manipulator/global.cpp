#include "core/manipulator/global.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/units.h"
#include "core/chain/closed_form.h"
#include "core/manipulator/closed_form.h"

namespace underact::manipulator {
namespace {

constexpr int kSteps = 200;            // of one descent
constexpr double kSameMinimum = 1e-6;  // of the reach
constexpr double kSettled = 1e-7;      // of the joints: a descent that still moves by more has not converged
constexpr double kSameEnergy = 1e-9;
constexpr double kNothing = 1e-26;  // relative to the energy at a reach's distance: below it counts as 0

/// The number of starts: 64 for one joint and 16 by 16 for two, on a grid; from 3 joints on 160 for each.
std::size_t startsOf(std::size_t joints) {
  return joints == 1 ? 64 : joints == 2 ? 256 : 160 * joints;
}

/// The radical inverse of index in a base. Source: Halton 1960.
double halton(std::size_t index, std::size_t base) {
  double result = 0.0, digit = 1.0;
  for (; index > 0; index /= base) {
    digit /= static_cast<double>(base);
    result += digit * static_cast<double>(index % base);
  }
  return result;
}

std::vector<Values> startsFor(const Manipulator& m, const Pose& X_WT) {
  constexpr std::array<std::size_t, kMaxJoints> kBases{2, 3, 5, 7, 11, 13, 17, 19};
  const std::size_t joints = m.chain.joints.size();
  std::vector<Values> starts{clampedToLimits(m, {})};
  if (const auto arm = chain::recognise(m.chain)) {
    const chain::Solutions solutions = chain::solveAll(*arm, X_WT);
    for (std::size_t k = 0; k < solutions.count; ++k) {
      Values theta{};
      std::copy(solutions.all[k].q.begin(), solutions.all[k].q.end(), theta.begin());
      starts.push_back(clampedToLimits(m, theta));
    }
  }
  // As far as the stylus, and beyond.
  const double slide_m = m.reach_m + (X_WT.translation() - m.chain.X_WT_home.translation()).norm();
  for (std::size_t k = 0; k < startsOf(joints); ++k) {
    Values theta{};
    for (std::size_t i = 0; i < joints; ++i) {
      const double share = joints == 1   ? (static_cast<double>(k) + 0.5) / 64.0
                           : joints == 2 ? (static_cast<double>(i == 0 ? k / 16 : k % 16) + 0.5) / 16.0
                                         : halton(k + 1, kBases[i]);
      theta[i] = valueAt(m.chain.joints[i], share, slide_m);
    }
    starts.push_back(clampedToLimits(m, theta));
  }
  return starts;
}

/// A minimum that a descent has found.
struct Minimum {
  Values theta{};
  Vec3 p_WV = Vec3::Zero();
  double energy_J = kInfinity;
};

/// The excess energy of the best minimum at another position of the tip.
double secondOf(const std::vector<Minimum>& minima, const Minimum& best, double near_m) {
  double second_J = kInfinity;
  for (const Minimum& one : minima) {
    if ((one.p_WV - best.p_WV).norm() > near_m) second_J = std::min(second_J, one.energy_J - best.energy_J);
  }
  return second_J;
}

}  // namespace

Global minEnergy(const Manipulator& m, const Pose& X_WT) {
  Global best;
  if (m.closed) {
    const Closed closed = closedForm(m, X_WT, clampedToLimits(m, {}));
    evaluate(m, X_WT, closed.theta, best.at);
    best.is_unique = closed.is_unique;
    return best;
  }
  const double scale_J = 0.5 * m.kp_N_per_m.maxCoeff() * m.reach_m * m.reach_m + m.ko_N_m_per_rad;
  std::vector<Minimum> minima;
  Minimum min;
  Energy at;
  for (const Values& start : startsFor(m, X_WT)) {
    evaluate(m, X_WT, start, at);
    const Descent descent = descend(m, X_WT, kSteps, at);
    best.steps += descent.steps;
    if (!(at.energy_J < kInfinity)) continue;
    if (descent.left <= kSettled) minima.push_back({at.theta, at.tip.X_WT.translation(), at.energy_J});
    // An improvement within rounding does not count: the first stays.
    if (at.energy_J < (1.0 - 1e-12) * min.energy_J) min = {at.theta, at.tip.X_WT.translation(), at.energy_J};
    if (at.energy_J <= kNothing * scale_J) break;  // none can be lower
  }
  // To the last bit that rounding allows, as there is no time limit.
  Manipulator exact = m;
  exact.options.tolerance = 0.0;
  evaluate(exact, X_WT, clampedToLimits(m, min.theta), best.at);
  best.steps += descend(exact, X_WT, kSteps, best.at).steps;
  best.second_J = secondOf(minima, min, kSameMinimum * m.reach_m);
  best.is_unique = min.energy_J < kInfinity && best.second_J > kSameEnergy * (min.energy_J + 1e-6 * scale_J);
  return best;
}

}  // namespace underact::manipulator
