#pragma once
#include "core/base/types.h"

namespace underact::gui {

/// A place of a recorded tip and the force sent there.
struct PathPoint {
  Vec3 p_mm = Vec3::Zero();
  double force_N = 0.0;
};

}  // namespace underact::gui
