#pragma once
#include "core/chain/chain.h"

namespace underact::chain {

/// 6 x n, on the stack: v of the tip T (m/rad or m/m) above w (rad/rad), both in W, for each joint's rate.
using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, static_cast<int>(kMaxJoints)>;

/// What kinematics() gives; J has a column for each joint.
struct Kinematics {
  Pose X_WT = Pose::Identity();
  Jacobian J;
};

// q: one value for each joint, rad or m. Joints without a value are at 0; values beyond the chain's joints are ignored.
// Not finite in, not finite out. Cost: linear in the joints. The same q gives the same bits on every machine.

/// X_WT. Within 64 ulp of the largest coordinate at home (of 1 for the orientation) times the sum of the angles, 1 rad
/// at least, and of the slides; the Jacobian too. Source: Lynch and Park, Modern Robotics, eq. 4.14.
Pose forward(const Chain& chain, std::span<const double> q) noexcept UNDERACT_REAL_TIME;

/// X_WT, and the displacement of each link since home: X_WLinks[i] = e^(S1 q1) ... e^(Si qi), which maps a point of
/// link i from its position at home to the present one. As many as X_WLinks has room for.
Pose forward(const Chain& chain, std::span<const double> q, std::span<Pose> X_WLinks) noexcept UNDERACT_REAL_TIME;

/// The geometric Jacobian at the tip. Source: Lynch and Park, eq. 5.11, shifted to the tip.
Jacobian jacobian(const Chain& chain, std::span<const double> q) noexcept UNDERACT_REAL_TIME;

/// Both in one pass.
Kinematics kinematics(const Chain& chain, std::span<const double> q) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::chain
