#pragma once
#include <array>
#include <optional>

#include "core/chain/kinematics.h"
#include "core/chain/wrist.h"

namespace underact::chain {

/// Six revolute joints whose last three axes meet in a point C (the wrist centre) and whose second and third axes are
/// parallel: most industrial arms, and the Omni. Made by recognise(). Everything is at home.
struct SphericalWristArm {
  std::array<Vec3, 6> axis_W;
  Vec3 p_WJ1 = Vec3::Zero();     // the point of axis 1 nearest to axis 2
  Vec3 offset_W = Vec3::Zero();  // from there to axis 2, across axis 2
  Vec3 upper_W = Vec3::Zero();   // from axis 2 to axis 3, across both
  Vec3 fore_W = Vec3::Zero();    // from axis 3 to C, across axis 3
  double upper_m = 0.0;          // their lengths
  double fore_m = 0.0;
  double along_m = 0.0;           // from p_WJ1 to C along axis 2, constant under joints 2 and 3
  double sense = 1.0;             // +1 where axes 2 and 3 point the same way, -1 where they oppose
  WristAxes wrist;                // axes 4 to 6
  double elbow_middle_rad = 0.0;  // joint 3 where C is furthest from axis 2
  Vec3 p_TC = Vec3::Zero();
  Mat3 R_TW = Mat3::Identity();
  double reach_m = 0.0;  // offset, along, upper and fore together: the scale of the tolerances
};

/// The chain as such an arm. Parallel, meeting and crossing are decided to 1e-9 rad and 1e-9 of the chain's reachOf().
/// None for other chains, nor where axes 1 and 2, 4 and 5 or 5 and 6 are parallel too, where axes 2 and 3 coincide, or
/// where C lies on axis 3: a joint would be free everywhere.
std::optional<SphericalWristArm> recognise(const Chain& chain) noexcept;

/// One solution for a pose. q: rad, in (-pi, pi]; joint limits are ignored. Three steps have two solutions each:
/// shoulder (joint 1), elbow (joint 3) and wrist (joint 5) say which, +1 the one that is rotated in the positive sense
/// from the middle of both; where the two coincide, there is +1 alone.
struct Solution {
  std::array<double, 6> q{};
  int shoulder = 1;
  int elbow = 1;
  int wrist = 1;
  bool exact = true;  // false: no solution exists, and this is the nearest configuration
};

/// What solveAll() found.
struct Solutions {
  std::array<Solution, 8> all{};
  std::size_t count = 0;  // how many of all there are, the exact ones first
  std::size_t exact = 0;  // how many of them are solutions
};

/// Every q with X_WT(q) = X_WT: 8 for a pose well inside the reach of an arm whose wrist has right angles. On the
/// boundary of the reach, from 1e-12 of the reach inside it to 1e-9 outside, two coincide. Singular: axes 4 and 6 in
/// line (1e-12 rad), with q4 = 0 for all; C on axis 1 of an arm that can keep it there, q1 = 0; C on axis 2, q2 = 0.
/// The pose of an exact solution is X_WT within the rounding of its joints, or 3e-9 of the reach on the boundary. X_WT:
/// its linear part a rotation. Never NaN: a pose that is not finite, or 1e9 reaches away, has no solutions. Cost:
/// constant. Source: Pieper 1968; Elias and Wen 2022, "IK-Geo: Unified Robot Inverse Kinematics Using Subproblem
/// Decomposition", spherical wrist with two parallel axes.
Solutions solveAll(const SphericalWristArm& arm, const Pose& X_WT) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::chain
