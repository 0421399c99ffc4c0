#pragma once
#include "core/extremes/row.h"
#include "core/tick/step.h"

namespace underact::extremes {

/// A program that runs along the path of a hand gets input that no arm sends, for one to three ticks: NaN, infinities,
/// denormals and 1e308 for an angle, any time, any fault. Then Start is pressed, and it goes on. Judged: every force is
/// finite and within its limit, and zero where the tick says why; all of the state stays finite (or is forgotten at the
/// Start); and after the Start it does what a program does that was never fed any of it, bit for bit. Error: ulp of the
/// greatest force beyond it.
Outcome judgeStrangeTick(const tick::TickProgram& program, Input& input);

/// Every number of the state is finite.
bool isFinite(const tick::TickState& state);

}  // namespace underact::extremes
