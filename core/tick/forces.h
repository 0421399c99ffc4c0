#pragma once
#include "core/base/real_time.h"
#include "core/tick/report.h"
#include "core/tick/state.h"

namespace underact::tick {

// Inside the room: the forces of step().

/// The force of all constraints, and of each in report.held; zero for one that is free, degenerate or not chosen.
/// displacement_T_W: the displacement of the tip since the last tick, m; zero where there was none.
Vec3 sumForces(const TickProgram& program, const control::LawInput& moment, const Vec3& displacement_T_W,
               TickState& state, TickReport& report) noexcept UNDERACT_REAL_TIME;

/// The moment of all virtual robots that act.
Vec3 sumMoments(const ConstraintReports& held) noexcept UNDERACT_REAL_TIME;

/// Removes the step in the force after a change of gains or targets: the difference is added and fades out.
void smoothForce(const control::LawInput& moment, TickState& state, Vec3& f_T_W) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::tick
