#pragma once
#include "core/tick/program.h"

namespace underact::tick {

/// The expected duration of a tick of the program, ns: median on the machine named with the guide's figures. A sum over
/// its parts, to compare scenes; no prediction for another machine.
double predictedCost_ns(const TickProgram& program);

}  // namespace underact::tick
