#include "core/arm/follower.h"

#include <algorithm>
#include <cmath>

#include "core/arm/planar.h"
#include "core/base/units.h"

namespace underact::arm {
namespace {

/// The angle of the same direction that is nearest to last_rad. Neither may be beyond 1e6 turns.
double nearestTurn(double angle_rad, double last_rad) noexcept UNDERACT_REAL_TIME {
  return angle_rad + 2.0 * kPi * std::nearbyint((last_rad - angle_rad) / (2.0 * kPi));
}

JointAngles nearestTurns(JointAngles q_rad, const JointAngles& last_rad) noexcept UNDERACT_REAL_TIME {
  for (std::size_t joint = 0; joint < q_rad.size(); ++joint) q_rad[joint] = nearestTurn(q_rad[joint], last_rad[joint]);
  return q_rad;
}

double wayBetween(const JointAngles& a_rad, const JointAngles& b_rad) noexcept UNDERACT_REAL_TIME {
  double way_rad = 0.0;
  for (std::size_t joint = 0; joint < a_rad.size(); ++joint) way_rad += std::abs(a_rad[joint] - b_rad[joint]);
  return way_rad;
}

/// Of a family, the member nearest to where the joints were: joint 4 stays, joint 6 makes up for it.
void choose(Solution& one, const JointAngles& last_rad) noexcept UNDERACT_REAL_TIME {
  if (one.family != Family::Q4PlusQ6 && one.family != Family::Q6MinusQ4) return;
  const double sum_sign = one.family == Family::Q4PlusQ6 ? 1.0 : -1.0;
  const double rest_rad = one.q_rad[5] + sum_sign * one.q_rad[3];
  one.q_rad[3] = last_rad[3];
  one.q_rad[5] = rest_rad - sum_sign * last_rad[3];
}

}  // namespace

Followed follow(const Geometry& geometry, const JointLimits& limits, const FollowerState& state,
                const Pose& X_WT) noexcept {
  Solutions solutions = solveAll(geometry, limits, X_WT);
  Followed result{state, solutions.reachable, false};
  if (solutions.count == 0) return result;
  const Solution* own = nullptr;
  const Solution* nearest = nullptr;
  double own_rad = kInfinity, nearest_rad = kInfinity;
  for (std::size_t index = 0; index < solutions.count; ++index) {
    Solution& one = solutions.all[index];
    choose(one, state.q_rad);
    one.q_rad = nearestTurns(one.q_rad, state.q_rad);
    const double way_rad = wayBetween(one.q_rad, state.q_rad);
    if (one.branch == state.branch) own = &one, own_rad = way_rad;
    if (way_rad < nearest_rad) nearest = &one, nearest_rad = way_rad;
  }
  // Where a singularity has made two branches one, the own one may have no entry: the one that stands for it is
  // nearest.
  const bool stays = own != nullptr && state.begun && own_rad <= nearest_rad + kSwitch_rad;
  const Solution& taken = stays ? *own : *nearest;
  result.next = {taken.q_rad, taken.branch, true};
  if (own == nullptr && state.begun) result.next.branch = state.branch;
  result.changed = state.begun && !(result.next.branch == state.branch);
  return result;
}

Followed followPosition(const Geometry& geometry, const FollowerState& state, const Vec3& p_WT) noexcept {
  const PlanarReach reach = planarReach(geometry, p_WT);
  Followed result{state, reach.reachable, false};
  double best_rad = kInfinity;
  const double shoulders[] = {1.0, -1.0}, elbows[] = {1.0, -1.0};
  for (const double shoulder : shoulders) {
    PlanarReach faced = reach;
    faced.off_axis_m *= shoulder;
    for (const double elbow : elbows) {
      const SinCos thigh = scaledThigh(geometry, faced, elbow);
      JointAngles q_rad = state.q_rad;
      if (reach.off_axis_m > kSingularDistance_m) q_rad[0] = atan2Of(shoulder * reach.y_m, shoulder * reach.x_m);
      q_rad[1] = atan2Of(thigh.sin, thigh.cos);
      q_rad[2] = atan2Of(reach.elbow.sin, elbow * reach.elbow.cos);
      q_rad = nearestTurns(q_rad, state.q_rad);
      const Branch branch{static_cast<std::int8_t>(shoulder), static_cast<std::int8_t>(elbow), state.branch.wrist};
      double way_rad = wayBetween(q_rad, state.q_rad);
      if (state.begun && branch == state.branch) way_rad -= kSwitch_rad;
      if (!(way_rad < best_rad)) continue;
      best_rad = way_rad;
      result.next = {q_rad, branch, true};
    }
  }
  result.changed = state.begun && !(result.next.branch == state.branch);
  return result;
}

}  // namespace underact::arm
