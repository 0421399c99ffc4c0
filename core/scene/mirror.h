#pragma once
#include "core/scene/description.h"

namespace underact::scene {

/// The scene as a mirror across the plane x = 0 of W shows it: for a stylus in the left hand. A stylus whose tip and
/// turn are mirrored, R_WT -> S R_WT diag(1, -1, 1) with S = diag(-1, 1, 1), is pushed by the mirror image of the
/// force; so is the arm whose joints 1, 4 and 6 turn the other way. What was loaded of a mesh or a curve stays: it is
/// its scale that goes below 0. Twice is the scene itself, to the last bit.
Description mirrored(Description scene);
Constraint mirrored(Constraint constraint);

}  // namespace underact::scene
