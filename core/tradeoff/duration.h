#pragma once
#include "core/scene/description.h"

namespace underact::tradeoff {

/// The expected duration of measurePoints() and measureChoices() together, s, on the machine of the guide's figures:
/// for a sentence that says "about". tick_ns: the duration of a tick of the scene.
double secondsToMeasure(const scene::Description& scene, std::size_t hands, double seconds, int rate_hz,
                        double tick_ns);

}  // namespace underact::tradeoff
