#pragma once
#include "core/tick/program.h"

namespace underact::tick {

/// What a tick of the program is expected to take, ns: median on the machine named in the guide's figures. A sum over
/// its parts, so it tells which of two scenes is dearer and by about how much; it is no promise for another machine.
double predictedCost_ns(const TickProgram& program);

}  // namespace underact::tick
