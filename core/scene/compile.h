#pragma once
#include "core/arm/preset.h"
#include "core/base/result.h"
#include "core/scene/description.h"
#include "core/tick/program.h"

namespace underact::scene {

/// The tick program of a scene: SI, immutable, with the quantities it needs and no others.
/// Problems: those of check(); none for what readScene() gave. The arm must be a known preset.
Result<tick::TickProgram> compile(const Description& scene);

/// A curve as the tick has it: in W, m; the same one as long as one of the same points, kind, scale and place is held
/// anywhere, so that an edit of gains does not make it anew. Problems: its file was not loaded; too few points.
Result<target::CurvePath> makeCurvePath(const Curve& curve, const Place& place = {});

}  // namespace underact::scene
