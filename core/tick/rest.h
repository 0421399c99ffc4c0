#pragma once
#include "core/tick/program.h"
#include "core/tick/report.h"

namespace underact::tick {

/// What a tick finds for a stylus that rests at p_WT (m, finite), turned by R_WT, and has no past: no rate, no
/// integral. held and f_T_W (asked, before the gate) are what is meant; force is zero, since the ramp has not begun. It
/// is step() that answers, so nothing here can differ from what the servo does. A program that works on joints (space:
/// joint) answers for the arm's own joints there, and so for p_WT within 1e-15 m; out of the arm's reach, for the
/// nearest place. A
/// virtual manipulator answers from a cold start with the least energy of all; where two places have as little, it is
/// degenerate. Allocates; not for the servo thread.
TickReport answerAtRest(const TickProgram& program, const Vec3& p_WT, const Mat3& R_WT);

}  // namespace underact::tick
