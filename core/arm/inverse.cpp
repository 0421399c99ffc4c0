#include "core/arm/inverse.h"

#include <algorithm>
#include <cmath>

#include "core/arm/forward.h"
#include "core/arm/mechanism.h"
#include "core/arm/planar.h"
#include "core/arm/wrist.h"
#include "core/base/trig.h"

namespace underact::arm {

PositionSolution solvePosition(const Geometry& geometry, const Vec3& p_WT) noexcept {
  if (!solvesInTick(geometry)) return {geometry.mechanism->rest, false};
  const PlanarReach at = planarReach(geometry, p_WT);
  const SinCos thigh = scaledThigh(geometry, at, 1.0);
  PositionSolution result;
  result.q_rad[0] = at.off_axis_m > 0.0 ? atan2Of(at.y_m, at.x_m) : 0.0;  // erratum 3.11
  result.q_rad[1] = atan2Of(thigh.sin, thigh.cos);                        // eq. 3.16
  result.q_rad[2] = atan2Of(at.elbow.sin, at.elbow.cos);                  // erratum 3.12
  result.reachable = std::abs(at.elbow_sin) <= 1.0 && at.off_axis_m > 0.0;
  return result;
}

JointAngles solveWrist(JointAngles q_rad, const Mat3& R_WT) noexcept {
  const Mat3 R_BT = workspaceFromBase().transpose() * R_WT;
  const Wrist wrist = wristOf(baseFromForearm(q_rad).transpose() * R_BT);
  q_rad[3] = wrist.q4_rad, q_rad[4] = wrist.q5_rad, q_rad[5] = wrist.q6_rad;
  return q_rad;
}

JointAngles withinLimits(const JointLimits& limits, JointAngles q_rad) noexcept {
  for (std::size_t joint = 0; joint < q_rad.size(); ++joint) {
    const bool is_size = joint == 4 && limits.of_wrist_size;
    const double size_rad = is_size ? std::abs(q_rad[joint]) : q_rad[joint];
    const double held_rad = std::clamp(size_rad, limits.min_rad[joint], limits.max_rad[joint]);
    q_rad[joint] = is_size ? std::copysign(held_rad, q_rad[joint]) : held_rad;
  }
  return q_rad;
}

}  // namespace underact::arm
