#pragma once
#include "app/gui/view/drawing.h"
#include "core/ghost/follow.h"

namespace underact::gui {

/// The ghost in the view: its stylus, its path ahead, fainter with time, and a dashed line from the tip to it with the
/// distance in whole mm. p_WT: the tip.
Drawing ghostDrawing(const ghost::Trajectory& trajectory, const ghost::State& state, const Vec3& p_WT);

}  // namespace underact::gui
