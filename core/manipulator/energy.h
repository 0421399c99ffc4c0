#pragma once
#include <span>

#include "core/base/linear_system.h"
#include "core/chain/kinematics.h"
#include "core/manipulator/manipulator.h"

namespace underact::manipulator {

/// The energy of a manipulator with the stylus, and its gradient over the joints, at one configuration.
struct Energy {
  Values theta{};
  chain::Kinematics tip;      // X_WV and J_V there
  Vec3 e_p_W = Vec3::Zero();  // p_V - p_T, m
  Vec3 e_o_W = Vec3::Zero();  // of the orientation, a rotation vector, rad (Axis: z_V - z_T, no unit)
  double weight = 1.0;        // Angle: how much the stylus's angle counts, see weightOfAngle()
  Vec3 f_W = Vec3::Zero();    // K e: the force on the hand, N
  Vec3 m_W = Vec3::Zero();    // and its moment about T, N m; few arms render it
  double energy_J = kInfinity;
  Values slope{};  // dV/dtheta, N m/rad or N
};

/// The second derivatives of the energy over the joints, see curvature().
using Hessian = SymmetricSystem<kMaxJoints>;

/// Evaluates energy and gradient. X_WT: the stylus. theta: a value for each joint. Both within 64 ulp of (kp length^2 +
/// ko + springs) times the sum of the angles, 1 rad at least, where length is the largest one involved; of Angle, the
/// part of ko as in the guide's robot_angle. Not finite in, not finite out.
void evaluate(const Manipulator& manipulator, const Pose& X_WT, const Values& theta,
              Energy& at) noexcept UNDERACT_REAL_TIME;

/// d2V/dtheta2, its lower half. spread: for each joint a bound of its row: the diagonal of J^T K J and the size of the
/// second-order terms, with 1 rad of a revolute joint equal to the reach of a prismatic one, so that H + diag(spread)
/// is positive definite in any unit of length. second_order false: J^T K J alone. Source: errata section 6; the
/// derivative of a serial chain's Jacobian is dJ_j/dtheta_i = w_i x J_j for i <= j.
void curvature(const Manipulator& manipulator, const Energy& at, bool second_order, Hessian& H,
               Values& spread) noexcept UNDERACT_REAL_TIME;

/// The weight of the stylus's angle about a joint's axis, 0 to 1: it fades within 5 degrees of the axis, where the
/// angle is undefined. stylus_W: unit.
double weightOfAngle(const Vec3& axis_W, const Vec3& stylus_W) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::manipulator
