#pragma once
#include "core/safety/gate.h"

namespace underact::safety {

// Each limit, applied to a force of at most max_force_N. None makes it larger or not finite.

inline constexpr double kWarm = 0.9;  // heat from which on the force is cut

/// Whether all three are finite.
bool isFinite(const Vec3& v) noexcept UNDERACT_REAL_TIME;

/// The length of any force without overflow, N.
double sizeOf(const Vec3& f_T_W) noexcept UNDERACT_REAL_TIME;

/// The filtered velocity a tick later. Backward Euler, 5 ms: one encoder step in a tick of 0.1 ms is 0.5 m/s raw.
Vec3 followVelocity(const Vec3& last_W, const Vec3& v_WT, double dt_s) noexcept UNDERACT_REAL_TIME;

/// The part of f_T_W that drives the stylus along v_WT fades between the calm and the greatest speed.
Vec3 limitSpeed(const Limits& limits, const Vec3& v_WT, const Vec3& f_T_W) noexcept UNDERACT_REAL_TIME;

/// The share that limitSpeed() leaves of a force along v_WT.
double speedShare(const Limits& limits, const Vec3& v_WT) noexcept UNDERACT_REAL_TIME;

/// A force on the tip and a moment about it, N and N m, in W. The limits of joints scale both, or leave both.
struct Wrench {
  Vec3 f_T_W = Vec3::Zero();
  Vec3 m_T_W = Vec3::Zero();
};

/// The part of both that the motors render; both as they are where that is all but a rounding of them.
Wrench limitMotors(const Motion& motion, const Wrench& wrench) noexcept UNDERACT_REAL_TIME;

/// The share of both that remains where they would press a driven joint against its stop.
double edgeShare(const Limits& limits, const Motion& motion, const Wrench& wrench) noexcept UNDERACT_REAL_TIME;

/// The share of both with which no motor gets hotter than 1, and none exceeds the largest torque that it has. No limit
/// of heat up to 0.9; at 1 the continuous torque, which heats no further.
double torqueShare(const Limits& limits, const Heat& heat, const Motion& motion,
                   const Wrench& wrench) noexcept UNDERACT_REAL_TIME;

/// The motors' heat a tick later: dh/dt = ((torque / continuous)^2 - h) / time constant, as copper loss warms a motor.
/// A motor beyond those of the motion has no torque: it cools.
Heat heated(const Thermal& thermal, const Heat& heat, const Motion& motion, const Wrench& wrench,
            double dt_s) noexcept UNDERACT_REAL_TIME;

/// f_T_W, or the point on the way from last_T_W to it that the slew limit allows in dt_s. Within 4 ulp of both.
Vec3 limitSlew(const Limits& limits, const Vec3& last_T_W, const Vec3& f_T_W, double dt_s) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::safety
