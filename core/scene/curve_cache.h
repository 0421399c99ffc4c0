#pragma once
#include <memory>

#include "core/curve/curve.h"
#include "core/scene/description.h"

namespace underact::scene {

// Internal to the room: a curve of a million points takes a second to build, and an edit of gains does not change it.

/// The curve as the tick has it, in W, m: the existing one of the same points, kind, scale and pose while it is held
/// anywhere; else a new one. Its points must be loaded. Any thread but the servo's. Problems: those of
/// curve::makeCurve().
Result<std::shared_ptr<const curve::Curve>> cachedCurve(const Curve& curve, const SourceLocation& place);

}  // namespace underact::scene
