#pragma once
#include <cstdint>

#include "core/chain/kinematics.h"

namespace underact::chain {

/// When solveNumerically() stops, and what counts.
struct NumericOptions {
  int max_steps = 60;           // of each start
  double tolerance_m = 1e-9;    // of the tip's place
  double tolerance_rad = 1e-9;  // of its turn
  int restarts = 0;             // further starts, drawn at random, where the first stays in a dead end
  std::uint64_t seed = 1;       // of those draws
  bool within_limits = false;  // the answer keeps the joints' limits; if not, revolute joints come wrapped to (-pi, pi]
  // A turn of 1 rad weighs as much as a way of this length. Below 0: the chain's reachOf(). 0: the turn does not count,
  // and the tip is brought to the place alone (chains of three joints, say).
  double rotation_length_m = -1.0;
};

/// What solveNumerically() found.
struct NumericSolution {
  JointValues q{};       // the nearest there was, reached or not
  bool reached = false;  // both residuals within the tolerances
  double residual_m = kInfinity;
  double residual_rad = kInfinity;  // the angle between the turns, in [0, pi]; measured even where it does not count
  int steps = 0;                    // Jacobians taken, over all starts
  int restarts_used = 0;
};

/// A q that brings the tip to X_WT, by damped least squares from q_start (a joint it is too short for starts at 0).
/// Any chain; joints may be fewer or more than 6, and a pose out of reach gives the nearest one that was met.
/// Each start ends in a solution, in a dead end or after max_steps. Random starts lie within the joints' limits, or
/// where these are infinite within a turn, or the reach, either way. Deterministic: the same bits from the same
/// arguments. Not finite in, not reached out, q as started. Cost: at most max_steps (restarts + 1) steps, of some 0.7
/// us for six joints. Source: Levenberg 1944; the damping in step with the squared residual as Fan and Yuan 2005.
NumericSolution solveNumerically(const Chain& chain, const Pose& X_WT, std::span<const double> q_start,
                                 const NumericOptions& options) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::chain
