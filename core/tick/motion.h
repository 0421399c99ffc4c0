#pragma once
#include "core/base/real_time.h"
#include "core/tick/report.h"
#include "core/tick/state.h"
#include "core/tick/step.h"

namespace underact::tick {

// Inside the room: what step() finds out about the arm.

/// 0 at the first tick. The difference wraps instead of overflowing; what wraps is stale.
double secondsSince(const TickState& state, std::int64_t time_ns) noexcept UNDERACT_REAL_TIME;

/// What the gate goes by.
struct GateTime {
  double dt_s = 0.0;
  double waited_s = 0.0;
  double way_s = 0.0;  // in which the tip went its way since the last sample that counted
};

/// Ramps, slew, heat and frozen time go by the servo's periods, so that a sample's clock cannot hold a force. Nothing
/// is pushed at the first sample, which says of no motion. before: the state at the tick's beginning; by_arm_s: since
/// the last sample by the arm's clock; what the laws go by is law_dt_s.
GateTime gateTimeOf(const TickInput& input, const TickState& before, double by_arm_s,
                    double law_dt_s) noexcept UNDERACT_REAL_TIME;

/// Where the tip is; and where the stylus points, if any target asks.
void lookAtArm(const TickProgram& program, const arm::JointAngles& q_rad, TickReport& report,
               safety::Motion& motion) noexcept UNDERACT_REAL_TIME;

/// How the arm moved since the last sample, and how far its driven joints are from their stops. dt_s: 0 where there is
/// no last sample to compare with.
void lookAtMotion(const TickProgram& program, const arm::JointAngles& q_rad, const TickState& before, double dt_s,
                  const Vec3& p_WT, safety::Motion& motion) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::tick
