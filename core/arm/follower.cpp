#include "core/arm/follower.h"

#include <algorithm>
#include <cmath>

#include "core/arm/planar.h"
#include "core/base/units.h"
#include "core/base/valid_bytes.h"

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

double distanceBetween(const JointAngles& a_rad, const JointAngles& b_rad) noexcept UNDERACT_REAL_TIME {
  double travel_rad = 0.0;
  for (std::size_t joint = 0; joint < a_rad.size(); ++joint) travel_rad += std::abs(a_rad[joint] - b_rad[joint]);
  return travel_rad;
}

/// Chooses the member of a self-motion nearest to the last joint angles: joint 4 stays, joint 6 compensates.
void choose(Solution& one, const JointAngles& last_rad) noexcept UNDERACT_REAL_TIME {
  if (one.family != Family::Q4PlusQ6 && one.family != Family::Q6MinusQ4) return;
  const double sum_sign = one.family == Family::Q4PlusQ6 ? 1.0 : -1.0;
  const double rest_rad = one.q_rad[5] + sum_sign * one.q_rad[3];
  one.q_rad[3] = last_rad[3];
  one.q_rad[5] = rest_rad - sum_sign * last_rad[3];
}

}  // namespace

bool isValid(const FollowerState& state) noexcept {
  const auto isSide = [](std::int8_t side) { return side == 1 || side == -1; };
  return isFlag(state.begun) && isSide(state.branch.shoulder) && isSide(state.branch.elbow) &&
         isSide(state.branch.wrist);
}

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
    const double travel_rad = distanceBetween(one.q_rad, state.q_rad);
    if (one.branch == state.branch) own = &one, own_rad = travel_rad;
    if (travel_rad < nearest_rad) nearest = &one, nearest_rad = travel_rad;
  }
  // Where two branches coincide at a singularity, the present one may have no entry: then the one that represents it is
  // the nearest.
  const bool stays = own != nullptr && state.begun && own_rad <= nearest_rad + kSwitch_rad;
  const Solution& taken = stays ? *own : *nearest;
  result.next = {taken.q_rad, taken.branch, true};
  if (own == nullptr && state.begun) result.next.branch = state.branch;
  result.changed = state.begun && !(result.next.branch == state.branch);
  return result;
}

Followed followPosition(const Geometry& geometry, const FollowerState& state, const Vec3& p_WT) noexcept {
  const PlanarReach reach = planarReach(geometry, p_WT);
  const auto solveOn = [&](const Branch& branch) {
    PlanarReach faced = reach;
    faced.off_axis_m *= branch.shoulder;
    const SinCos thigh = scaledThigh(geometry, faced, branch.elbow);
    JointAngles q_rad = state.q_rad;
    if (reach.off_axis_m > kSingularDistance_m) {
      q_rad[0] = atan2Of(branch.shoulder * reach.y_m, branch.shoulder * reach.x_m);
    }
    const auto [q2_rad, q3_rad] = atan2OfTwo(thigh.sin, thigh.cos, reach.elbow.sin, branch.elbow * reach.elbow.cos);
    q_rad[1] = q2_rad, q_rad[2] = q3_rad;
    return nearestTurns(q_rad, state.q_rad);
  };
  Followed result{state, reach.reachable, false};
  double min_rad = kInfinity;
  if (state.begun) {
    result.next.q_rad = solveOn(state.branch);
    min_rad = distanceBetween(result.next.q_rad, state.q_rad) - kSwitch_rad;
    if (min_rad <= 0.0) return result;  // nothing is nearer than no motion
  }
  for (const std::int8_t shoulder : {std::int8_t{1}, std::int8_t{-1}}) {
    for (const std::int8_t elbow : {std::int8_t{1}, std::int8_t{-1}}) {
      const Branch branch{shoulder, elbow, state.branch.wrist};
      const JointAngles q_rad = solveOn(branch);
      const double travel_rad = distanceBetween(q_rad, state.q_rad);
      if (!(travel_rad < min_rad)) continue;
      min_rad = travel_rad;
      result.next = {q_rad, branch, true};
    }
  }
  result.changed = state.begun && !(result.next.branch == state.branch);
  return result;
}

}  // namespace underact::arm
