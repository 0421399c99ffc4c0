#pragma once
#include "core/manipulator/energy.h"

namespace underact::manipulator {

/// Where a descent ended.
struct Descent {
  int steps = 0;            // steps tried, each an evaluation of the chain
  double left = kInfinity;  // the largest step that a joint would still take by itself: rad, or shares of the reach
  bool converged = false;   // left is within the tolerance
};

/// Descends from `at` (evaluated there) to the nearest local minimum of the energy, and leaves `at` there; at most
/// max_steps steps, each at most half a radian or a quarter of the reach. Joint limits are kept. Deterministic. A robot
/// and a stylus scaled together take the same steps.
/// Cost: for each step an evaluation and the solution of a system of the size of the joints; no step where `at` is a
/// minimum already. Source: Levenberg 1944, Marquardt 1963; damping as Nielsen 1999 (IMM-REP-1999-05); the second-order
/// term because the residual stays large here, where the Gauss-Newton step stalls (errata section 6, 5.17b).
Descent descend(const Manipulator& manipulator, const Pose& X_WT, int max_steps,
                Energy& at) noexcept UNDERACT_REAL_TIME;

/// theta within the limits of the joints; a joint without limits that turns, in [-pi, pi].
Values clampedToLimits(const Manipulator& manipulator, Values theta) noexcept UNDERACT_REAL_TIME;

/// A joint's value at a share, 0 to 1, of its range: from limit to limit; where one is missing, a whole turn or twice
/// slide_m, about home if the other limit allows it.
double valueAt(const chain::Joint& joint, double share, double slide_m) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::manipulator
