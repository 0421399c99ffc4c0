#pragma once
#include <memory>

#include "core/curve/curve.h"
#include "core/scene/description.h"

namespace underact::scene {

// Internal to the room: a curve of a million points takes a second to build, and an edit of gains does not change it.

/// The curve as the tick uses it, in W, m: an existing one with the same points, kind, scale and placement while anyone
/// holds it, otherwise a new one. Its points must be loaded. Not for the servo thread. Problems: those of
/// curve::makeCurve().
Result<std::shared_ptr<const curve::Curve>> keptCurve(const Curve& curve, const Place& place);

}  // namespace underact::scene
