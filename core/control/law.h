#pragma once
#include <variant>

#include "core/base/real_time.h"
#include "core/base/types.h"
#include "core/control/velocity.h"

namespace underact::control {

/// Proportional: f = kp e, axis by axis of W. Source: Beckman 2007, eq. B.13 with eq. 4.1.
struct P {
  Vec3 kp_N_per_m = Vec3::Zero();
};

/// Proportional and derivative: f = kp e + kd de/dt, the rate by one of the filters. The rate of the error, not of the
/// tip: the stylus moves along the constraint without drag. Source: eq. 4.1 with the K_e term that its left side omits.
struct PD {
  Vec3 kp_N_per_m = Vec3::Zero();
  Vec3 kd_N_s_per_m = Vec3::Zero();
  Velocity velocity = {};
};

/// With integral: + the integral of ki e, kept as a force so that a change of ki makes no jump. It is held within
/// integral_limit_N, does not grow on an axis on which the gate cuts the force, and is cleared while the servo is idle
/// and on an axis whose ki is 0. Source: eq. B.15 (with its missing d tau).
struct PID {
  Vec3 kp_N_per_m = Vec3::Zero();
  Vec3 kd_N_s_per_m = Vec3::Zero();
  Vec3 ki_N_per_m_s = Vec3::Zero();
  double integral_limit_N = 0.0;
  Velocity velocity = {};
};

/// The control law of a constraint; see CONTRIBUTING.md, "Adding a control law".
using Law = std::variant<P, PD, PID>;

/// The state of a law between ticks. P has none.
struct LawState {
  VelocityState velocity = {};       // of the error, m/s
  Vec3 integral_T_W = Vec3::Zero();  // N
};

/// The input of a law besides the error.
struct LawInput {
  double dt_s = 0.0;     // since the last tick; 0: the first
  bool limited = false;  // the gate cut or ramped the last force: do not wind up
  bool idle = false;     // no force is sent at all
};

/// The force on the tip, N, in W, for the error e_W = p_WP - p_WT, m. Within 64 ulp of kp |e| + kd |rate| and of all
/// that the integral has moved (P: 1 ulp, PD: 8). Finite in, finite out (up to overflow, which the gate refuses). state
/// is not touched by P. Cost: constant.
Vec3 force(const P& law, const Vec3& e_W) noexcept UNDERACT_REAL_TIME;
Vec3 force(const Law& law, LawState& state, const Vec3& e_W, const LawInput& moment) noexcept UNDERACT_REAL_TIME;

/// To be called instead of force() when there is no error. lost: its rate is unknown, too (a degenerate target);
/// otherwise the error is zero (an untouched wall), from which a contact starts.
void rest(LawState& state, bool lost) noexcept UNDERACT_REAL_TIME;

/// Resets the state to that before a first tick.
void reset(LawState& state) noexcept UNDERACT_REAL_TIME;

/// For bytes from a file: whether the state can be used. Its forces may be not finite, as requested forces may: the
/// gate refuses those.
inline bool isValid(const LawState& state) noexcept {
  return isValid(state.velocity);
}

/// Whether the law has a derivative part, which needs the rate of the error.
bool needsRate(const Law& law);
/// Whether the law has an integral, of which LawState keeps the force.
bool needsIntegral(const Law& law);

/// The proportional gains of any law.
const Vec3& stiffness(const Law& law) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::control
