#pragma once
#include "core/tick/program.h"
#include "core/tick/report.h"

namespace underact::tick {

/// The result of a tick for a stylus that rests at p_WT (m, finite) with the orientation R_WT and has no past: no rate,
/// no integral. held and f_T_W (before the gate) count; force is zero, since the ramp has not begun. Computed by
/// step(), so it cannot differ from the servo. A program in joint space (space: joint) is evaluated at the arm's own
/// joints there, and so for p_WT within 1e-15 m; out of the arm's reach, at the nearest position. A virtual robot
/// starts cold and has the global minimum of energy; where two minima are equal, it is degenerate. Allocates; not for
/// the servo thread.
TickReport evaluateAtRest(const TickProgram& program, const Vec3& p_WT, const Mat3& R_WT);

/// The status of all constraints together: unique if one acts and pulls the stylus, free if none is touched.
target::Status statusOf(const ConstraintReports& held) noexcept;

}  // namespace underact::tick
