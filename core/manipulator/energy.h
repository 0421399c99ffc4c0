#pragma once
#include <span>

#include "core/base/linear_system.h"
#include "core/chain/kinematics.h"
#include "core/manipulator/manipulator.h"

namespace underact::manipulator {

/// The energy of a manipulator against a stylus, and its slope over the joints, at one place.
struct Energy {
  Values theta{};
  chain::Kinematics tip;      // X_WV and J_V there
  Vec3 e_p_W = Vec3::Zero();  // p_V - p_T, m
  Vec3 e_o_W = Vec3::Zero();  // of the turn, as a rotation vector, rad (Axis: z_V - z_T, no unit)
  double weight = 1.0;        // Angle: how much the stylus's angle counts, see weightOfAngle()
  Vec3 f_W = Vec3::Zero();    // K e: the force on the hand, N
  Vec3 m_W = Vec3::Zero();    // and the moment about T that belongs to it, N m; never sent
  double energy_J = kInfinity;
  Values slope{};  // dV/dtheta, N m/rad or N
};

/// The second derivatives of the energy over the joints, see curvature().
using Hessian = SymmetricSystem<kMaxJoints>;

/// X_WT: the stylus. theta: a value for each joint. Energy and slopes within 64 ulp of (kp length^2 + ko + springs)
/// times the sum of the angles, 1 rad at least, length that of all there is; of Angle the ko's share as in the guide's
/// robot_angle. Not finite in, not finite out.
void evaluate(const Manipulator& manipulator, const Pose& X_WT, const Values& theta,
              Energy& at) noexcept UNDERACT_REAL_TIME;

/// d2V/dtheta2, its lower half. spread: for each joint what bounds its row: J^T K J's diagonal and the size of the
/// second-order terms, 1 rad of what turns being the reach of what slides, so that H + diag(spread) is positive
/// definite in any unit of length. second_order false: J^T K J alone.
/// Source: errata section 6; the derivative of a serial chain's Jacobian is dJ_j/dtheta_i = w_i x J_j for i <= j.
void curvature(const Manipulator& manipulator, const Energy& at, bool second_order, Hessian& H,
               Values& spread) noexcept UNDERACT_REAL_TIME;

/// How much the stylus's angle about a joint's axis counts, 0 to 1: less and less within 5 degrees of the axis, where
/// it has none. stylus_W: unit.
double weightOfAngle(const Vec3& axis_W, const Vec3& stylus_W) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::manipulator
