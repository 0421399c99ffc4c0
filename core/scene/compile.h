#pragma once
#include "core/arm/preset.h"
#include "core/base/result.h"
#include "core/scene/description.h"
#include "core/tick/program.h"

namespace underact::scene {

/// The tick program of a scene: SI, immutable, computing only the quantities it needs. Problems: those of check(); none
/// for a scene from readScene(). The arm must be a known preset.
Result<tick::TickProgram> compile(const Description& scene);

/// A curve as the tick uses it: in W, m. Shared while anyone holds one with the same points, kind, scale and placement,
/// so that an edit of gains does not build it again. Problems: its file was not loaded; too few points.
Result<target::CurvePath> makeCurvePath(const Curve& curve, const Place& place = {});

}  // namespace underact::scene
