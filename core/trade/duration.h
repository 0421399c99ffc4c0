#pragma once
#include "core/scene/description.h"

namespace underact::trade {

/// How long measurePoints() and measureStandings() take together on a machine like that of the figures in the guide, s:
/// for a sentence that says "about". tick_ns: what a tick of the scene takes.
double secondsToMeasure(const scene::Description& scene, std::size_t hands, double seconds, int rate_hz,
                        double tick_ns);

}  // namespace underact::trade
