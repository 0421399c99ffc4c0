#pragma once
#include "core/safety/gate.h"

namespace underact::safety {

// What each limit makes of a force of at most max_force_N. All keep it finite, and none makes it larger.

/// Whether all three are finite.
bool isFinite(const Vec3& v) noexcept UNDERACT_REAL_TIME;

/// The size of any force without overflow, N.
double sizeOf(const Vec3& f_T_W) noexcept UNDERACT_REAL_TIME;

/// The filtered velocity a tick later. Backward Euler, 5 ms: one encoder step in a tick of 0.1 ms is 0.5 m/s raw.
Vec3 followVelocity(const Vec3& last_W, const Vec3& v_WT, double dt_s) noexcept UNDERACT_REAL_TIME;

/// The part of f_T_W that drives the stylus along v_WT fades between the calm and the greatest speed.
Vec3 limitSpeed(const Limits& limits, const Vec3& v_WT, const Vec3& f_T_W) noexcept UNDERACT_REAL_TIME;

/// The whole force fades where it would press a driven joint against its stop.
Vec3 limitEdge(const Limits& limits, const Motion& motion, const Vec3& f_T_W) noexcept UNDERACT_REAL_TIME;

/// The whole force is cut so that no motor gets hotter than 1. Free up to 0.9; at 1 it may turn as hard as it bears for
/// good, which heats no further.
Vec3 limitHeat(const Thermal& thermal, const Vec3& heat, const Mat3& J_p,
               const Vec3& f_T_W) noexcept UNDERACT_REAL_TIME;

/// The motors' heat a tick later: dh/dt = ((torque / continuous)^2 - h) / time constant, as copper loss warms a motor.
Vec3 heated(const Thermal& thermal, const Vec3& heat, const Mat3& J_p, const Vec3& f_T_W,
            double dt_s) noexcept UNDERACT_REAL_TIME;

/// Within 4 ulp of both. f_T_W, or as far on the way from last_T_W to it as the slew limit goes in dt_s.
Vec3 limitSlew(const Limits& limits, const Vec3& last_T_W, const Vec3& f_T_W, double dt_s) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::safety
