#pragma once
#include "core/base/real_time.h"
#include "core/tick/report.h"
#include "core/tick/state.h"

namespace underact::tick {

// Inside the room: what step() makes of targets.

/// The force of all constraints, and of each in report.held; zero of one that is free, degenerate or not chosen.
/// way_T_W: of the tip since the last tick, m; zero where there was none.
Vec3 sumForces(const TickProgram& program, const control::Moment& moment, const Vec3& way_T_W, TickState& state,
               TickReport& report) noexcept UNDERACT_REAL_TIME;

/// Takes the step out of a change of gains or targets: what the force would have jumped by is kept beside it and fades.
void smoothOver(const control::Moment& moment, TickState& state, Vec3& f_T_W) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::tick
