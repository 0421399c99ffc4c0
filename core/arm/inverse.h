#pragma once
#include "core/arm/preset.h"
#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::arm {

/// The joints that bring the tip to a place. reachable false: the place lies outside the reach, or on axis 1, and
/// q_rad brings the tip as near as the arm can get in that direction. Reachable, it comes back within 16 ulp of the
/// reach and the places, and of reach^2 / |p_BT| where the elbow is folded up to the shoulder.
struct Reach {
  JointAngles q_rad{};
  bool reachable = false;
};

/// Joints 1 to 3 for p_WT, m, on the arm's ordinary branch (turret facing the tip, elbow as the real arm's); joints 4
/// to 6 are left at 0. Source: Beckman 2007, eq. 3.11-3.16 as errata section 2 corrects them. Never NaN for finite
/// input.
Reach reach(const Geometry& geometry, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME;

/// Joints 4 to 6 that turn the stylus to R_WT, given joints 1 to 3 in q_rad; joint 5 positive. Where it is 0 or pi,
/// joint 4 is 0. Source: eq. 3.17-3.20 as errata section 2 corrects them.
JointAngles withWrist(JointAngles q_rad, const Mat3& R_WT) noexcept UNDERACT_REAL_TIME;

/// q_rad with each joint brought inside its limits.
JointAngles withinLimits(const JointLimits& limits, JointAngles q_rad) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::arm
