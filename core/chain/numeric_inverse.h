#pragma once
#include <cstdint>

#include "core/chain/kinematics.h"

namespace underact::chain {

/// When solveNumerically() stops, and what counts.
struct NumericOptions {
  int max_steps = 60;           // of each start
  double tolerance_m = 1e-9;    // of the tip's position
  double tolerance_rad = 1e-9;  // of its orientation
  int restarts = 0;             // further random starts, where the first ends in a local minimum
  std::uint64_t seed = 1;       // of those draws
  bool within_limits = false;   // whether joint limits are kept; if not, revolute joints are wrapped to (-pi, pi]
  // The length that weighs as much as a rotation by 1 rad. Below 0: the chain's reachOf(). 0: the orientation does not
  // count, and only the position is reached (for chains of three joints, say).
  double rotation_length_m = -1.0;
};

/// What solveNumerically() found.
struct NumericSolution {
  JointValues q{};       // the nearest configuration found, reached or not
  bool reached = false;  // both residuals within the tolerances
  double residual_m = kInfinity;
  double residual_rad = kInfinity;  // the angle between the orientations, in [0, pi], even where it does not count
  int steps = 0;                    // Jacobians taken, over all starts
  int restarts_used = 0;
};

/// Joints drawn at random: within their limits, or where these are infinite within a turn, or the reach, either way.
/// random: the state of the sequence, at first its seed.
JointValues drawnJoints(const Chain& chain, std::uint64_t& random) noexcept UNDERACT_REAL_TIME;

/// A q that brings the tip to X_WT, by damped least squares from q_start (joints without a value start at 0). Any
/// chain, with fewer or more than 6 joints; a pose out of reach gives the nearest one that was found. Each start ends
/// in a solution, in a local minimum or after max_steps. Random starts are those of drawnJoints(). Deterministic to the
/// bit. Not finite in: not reached, q as started. Cost: at most max_steps (restarts + 1) steps, of some 0.7 us for six
/// joints. Source: Levenberg 1944; damping in proportion to the squared residual as Fan and Yuan 2005.
NumericSolution solveNumerically(const Chain& chain, const Pose& X_WT, std::span<const double> q_start,
                                 const NumericOptions& options) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::chain
