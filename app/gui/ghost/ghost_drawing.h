#pragma once
#include "app/gui/view/drawing.h"
#include "core/follow/follow.h"

namespace underact::gui {

/// What the view shows of a ghost: its stylus, the way that it goes next, fainter the later it is, and from the tip a
/// dashed line to it with the distance, whole mm. p_WT: the tip.
Drawing ghostDrawing(const follow::Way& way, const follow::State& state, const Vec3& p_WT);

}  // namespace underact::gui
