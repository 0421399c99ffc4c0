#pragma once
#include "core/arm/preset.h"
#include "core/base/result.h"
#include "core/scene/description.h"
#include "core/tick/program.h"

namespace underact::scene {

/// The tick program of a scene: SI, immutable, with the quantities it needs and no others. Problems: those of check(),
/// none for a scene of readScene(); an arm that is not a known preset.
Result<tick::TickProgram> compile(const Description& scene);

/// A curve as the tick has it: in W, m. The same object while one of the same points, kind, scale and pose is held
/// anywhere, so that an edit of gains does not rebuild it. Problems: its file was not loaded; too few points.
Result<target::CurvePath> makeCurvePath(const Curve& curve, const SourceLocation& place = {});

}  // namespace underact::scene
