#pragma once
#include "core/arm/mechanism.h"
#include "core/base/real_time.h"
#include "core/tick/report.h"
#include "core/tick/state.h"
#include "core/tick/step.h"

namespace underact::tick {

// Inside the room: the motion of the arm in step(). But for watchJoints(), which the computer of a remote arm calls,
// too.

/// The time since the last tick's sample, s; 0 at the first tick. The difference wraps instead of overflowing; then the
/// sample counts as stale.
double secondsSince(const TickState& state, std::int64_t time_ns) noexcept UNDERACT_REAL_TIME;

/// The times that the gate uses.
struct GateTime {
  double dt_s = 0.0;
  double waited_s = 0.0;
  double motion_s = 0.0;  // of the tip's motion since the last sample that counted
};

/// Ramps, slew, heat and frozen time use the servo's periods, so that the clock of the samples cannot hold a force. At
/// the first sample there is no motion and no force. before: the state at the tick's beginning; by_arm_s: since the
/// last sample by the arm's clock; law_dt_s: the time that the laws use.
GateTime gateTimeOf(const TickInput& input, const TickState& before, double by_arm_s,
                    double law_dt_s) noexcept UNDERACT_REAL_TIME;

/// The driven joints: how they move the tip by their columns of J, and their distances from their stops.
void watchJoints(const arm::Watched& watched, const arm::JointLimits& limits, const arm::JointAngles& q_rad,
                 const chain::Jacobian& J, safety::Motion& motion) noexcept UNDERACT_REAL_TIME;

/// Computes the position of the tip, the direction of the stylus where a target needs it, and of the driven joints what
/// the gate needs: what they render, and their distances from their stops.
void computeKinematics(const TickProgram& program, const arm::JointAngles& q_rad, TickReport& report,
                       safety::Motion& motion) noexcept UNDERACT_REAL_TIME;

/// Computes the motion of the arm since the last sample. dt_s: 0 where there is no last sample.
void computeMotion(const arm::JointAngles& q_rad, const TickState& before, double dt_s, const Vec3& p_WT,
                   safety::Motion& motion) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::tick
