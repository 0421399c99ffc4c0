#pragma once
#include "core/arm/preset.h"
#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::arm {

/// The joint angles for a position of the tip. reachable false: the position is out of reach, or on axis 1, and q_rad
/// brings the tip as near as the arm gets in that direction. If reachable, its forward kinematics is right within 16
/// ulp of the reach and the coordinates, and of reach^2 / |p_BT| where the elbow is folded up to the shoulder.
struct PositionSolution {
  JointAngles q_rad{};
  bool reachable = false;
};

/// Joints 1 to 3 for p_WT, m, on the arm's usual branch (turret facing the tip, elbow as of the real arm); joints 4 to
/// 6 are left at 0. Source: Beckman 2007, eq. 3.11-3.16 as errata section 2 corrects them. No NaN for finite input. An
/// arm that does not solvesInTick() answers its rest, not reachable.
PositionSolution solvePosition(const Geometry& geometry, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME;

/// Joints 4 to 6 for the orientation R_WT, given joints 1 to 3 in q_rad; joint 5 positive. Where it is 0 or pi, joint 4
/// is 0. Source: eq. 3.17-3.20 as errata section 2 corrects them.
JointAngles solveWrist(JointAngles q_rad, const Mat3& R_WT) noexcept UNDERACT_REAL_TIME;

/// q_rad with each joint clamped to its limits.
JointAngles withinLimits(const JointLimits& limits, JointAngles q_rad) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::arm
