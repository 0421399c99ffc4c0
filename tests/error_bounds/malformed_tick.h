#pragma once
#include "core/tick/step.h"
#include "tests/error_bounds/row.h"

namespace underact::error_bounds {

/// Feeds a program that runs along a hand's path with input that no arm sends, for one to three ticks: NaN, infinities,
/// denormals and 1e308 for an angle, any time, any fault. Then Start is pressed, and it continues. Tested: every force
/// is finite and within its limit, and zero where the tick says why; all of the state stays finite (or is reset at the
/// Start); and after the Start the program behaves, bit for bit, like one that never had that input. Error: ulp of the
/// greatest force beyond the limit.
Outcome checkMalformedTick(const tick::TickProgram& program, Input& input);

/// Whether every number of the state is finite.
bool isFinite(const tick::TickState& state);

}  // namespace underact::error_bounds
