#pragma once
#include "core/scene/description.h"

namespace underact::lab {

/// The scene with all that it holds the stylus to moved by by_mm, in W; what robots turn about and slide along, too.
scene::Description withTargetsMoved(scene::Description scene, const Vec3& by_mm);

}  // namespace underact::lab
