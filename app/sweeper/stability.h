#pragma once
#include "core/sweep/kind.h"

namespace underact::sweep {

/// How stiff walls may be against their damping: the cells of the lab's maps, and of walls that are drawn.
Kind stabilityKind();

}  // namespace underact::sweep
