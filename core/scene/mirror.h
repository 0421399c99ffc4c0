#pragma once
#include "core/scene/description.h"

namespace underact::scene {

/// The scene reflected across the plane x = 0 of W: for a stylus in the left hand. A stylus whose position and
/// orientation are reflected, R_WT -> S R_WT diag(1, -1, 1) with S = diag(-1, 1, 1), feels the reflected force; so does
/// the arm with joints 1, 4 and 6 negated. The loaded contents of a mesh or a curve stay: its scale becomes negative.
/// Twice is the scene itself, to the last bit.
Description mirrored(Description scene);
Constraint mirrored(Constraint constraint);

}  // namespace underact::scene
