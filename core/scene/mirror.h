#pragma once
#include "core/scene/description.h"

namespace underact::scene {

/// The scene mirrored across the plane x = 0 of W: for a stylus in the left hand. A stylus whose tip and orientation
/// are mirrored, R_WT -> S R_WT diag(1, -1, 1) with S = diag(-1, 1, 1), feels the mirror image of the force; so does
/// the arm whose joints 1, 4 and 6 turn the other way. What was loaded of a mesh or a curve stays: its scale becomes
/// negative. Mirroring twice gives the scene itself, to the last bit.
Description mirrored(Description scene);
Constraint mirrored(Constraint constraint);

}  // namespace underact::scene
