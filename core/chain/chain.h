#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/base/types.h"
#include "core/chain/dh.h"

namespace underact::chain {

inline constexpr std::size_t kMaxJoints = 16;

/// One value for each joint, rad or m, of a chain of up to kMaxJoints joints; 0 beyond the chain's joints.
using JointValues = std::array<double, kMaxJoints>;

/// A joint of a chain, with all joints at 0 ("home"): the direction of its axis, |axis_W| = 1, and for a revolute joint
/// a point J on it. min, max: the limits of its value, rad or m, infinite where there is none.
struct Joint {
  JointType type = JointType::Revolute;
  Vec3 axis_W = Vec3::UnitZ();
  Vec3 p_WJ = Vec3::Zero();
  double min = -kInfinity;
  double max = kInfinity;
};

/// A serial chain as a product of exponentials: X_WT(q) = e^(S1 q1) ... e^(Sn qn) X_WT_home, S the joints' screws in W.
/// Made by makeChain() or chainFromDh(), which leave 1 to kMaxJoints joints and unit axes.
/// Source: Lynch and Park, Modern Robotics, section 4.1.1.
struct Chain {
  std::vector<Joint> joints;
  Pose X_WT_home = Pose::Identity();
};

/// axis_W: any length but zero. Problems: no joint or more than kMaxJoints, an axis without a direction, a number that
/// is not finite (only limits may be infinite), limits without a range, a home pose whose linear part is not a
/// rotation.
Result<Chain> makeChain(std::vector<Joint> joints, const Pose& X_WT_home, const SourceLocation& place);

/// The chain of a DH table. X_WB: frame 0 in W; X_NT: the tool T in the last frame N. rows: 1 to kMaxJoints of them
/// (more are left out), of finite lengths and angles.
Chain chainFromDh(std::span<const DhRow> rows, const Pose& X_WB, const Pose& X_NT);

/// An upper bound of the tip's distance from the first joint's point J, m: the sum of the lengths from each J to the
/// next and on to the tip at home, and of the ranges of prismatic joints with limits. A scale for tolerances and
/// weights; exact only for the simplest chains. 0 where all points coincide.
double reachOf(const Chain& chain) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::chain
