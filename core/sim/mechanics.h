#pragma once
#include "core/sim/plant.h"

namespace underact::sim {

// Inside the room: how a simulated arm moves.

/// The weights of the velocities v at the beginning and v' at the end of a substep, which sum to 1: for the
/// displacement, and for the dampers. Without a mass there is no initial velocity, and v' alone counts: both 0.
struct Shares {
  double travel_begin = 0.0, damping_begin = 0.0;
};

/// Those of a mass that is integrated so.
inline Shares sharesOf(Integrator integrator) noexcept UNDERACT_REAL_TIME {
  if (integrator == Integrator::EndVelocity) return {0.0, 0.0};
  return {0.5, integrator == Integrator::Trapezoidal ? 0.5 : 0.0};
}

/// What the motors do to the tip: force and moment, N and N m.
struct Pushed {
  Vec3 f_T_W = Vec3::Zero(), m_T_W = Vec3::Zero();
};

/// How an arm rests and moves, and what its encoders measure.
struct Mechanics {
  /// At rest with the tip at p_WT, or as near as it comes; nullptr: where the arm is when nobody has moved it.
  PlantState (*restAt)(const Plant& plant, const Vec3* p_WT) noexcept UNDERACT_REAL_TIME;
  /// What sim::advance() does, of finite numbers; after an overflow a state that is not finite.
  PlantState (*advance)(const Plant& plant, PlantState state, const Pushed& pushed, const HandSetpoint& wish,
                        std::int64_t period_ns) noexcept UNDERACT_REAL_TIME;
  /// The angles that the encoders measure, and the joints for such angles.
  arm::JointAngles (*measuredOf)(const arm::JointAngles& q_rad) noexcept UNDERACT_REAL_TIME;
  arm::JointAngles (*jointsOf)(const arm::JointAngles& measured) noexcept UNDERACT_REAL_TIME;
};

/// Whether position and velocities are finite.
bool isFinite(const PlantState& state) noexcept UNDERACT_REAL_TIME;

/// Of an arm that solvesInTick(): a mass at the tip, and the joints for where it is.
extern const Mechanics kTipMechanics;

/// Of the joints of any other arm, of up to six and of more. With M the inertia of its links (of the model's
/// mass at the tip where the file has none) and of the hand, J_v and J_w the Jacobian at the tip, D the joints'
/// damping, and each substep's end marked by ', of the integrator EndVelocity,
///   M (dq' - dq) = dt (tau - D dq' + J_v^T (k (p_w - p') + b (v_w - v') - r v') + J_w^T (k_w e_w - b_w w')),
/// linear in dq' with p' = p + dt J_v dq', so that any stiffness and any step are stable. The others weigh dq and dq'
/// as Shares says, with J_v and J_w in the middle of the substep and r at the speed that a first solution finds. tau =
/// J_v^T f + J_w^T m at the driven joints, 0 at the others; r = friction / (speed + 1 mm/s) is Coulomb's friction
/// without its jump; k_w and b_w are k and b at a grip of 50 mm, k is 0 where the hand does not hold, and k_w where it
/// does not turn the stylus. A hand that leads the joints (posture) does so with M (100 e - 20 dq') in place of its
/// springs. M is that of the period's beginning. Weight and Coriolis forces are taken as compensated, as controllers do
/// while a person guides an arm. Source: Lynch and Park, Modern Robotics, eq. 8.78; Baraff and Witkin 1998 for the
/// linearised step.
extern const Mechanics kSixJointMechanics, kJointMechanics;

}  // namespace underact::sim
