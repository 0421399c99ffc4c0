#pragma once
#include "core/sweep/kind.h"

namespace underact::sweep {

/// The rows of `lab extremes`, each with as many seeds as one likes.
Kind extremesKind();

}  // namespace underact::sweep
