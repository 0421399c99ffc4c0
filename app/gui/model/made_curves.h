#pragma once
#include <vector>

#include "core/base/watch.h"
#include "core/scene/description.h"
#include "core/target/curve_target.h"

namespace underact::gui {

/// All curves of a scene that are loaded, so that whoever compiles it finds them made as long as they are held. A
/// spline of a million points takes a second. Any thread.
std::vector<target::CurvePath> madeCurves(const scene::Description& scene, const Watch& watch);

}  // namespace underact::gui
