#pragma once
#include "core/arm/mirror.h"
#include "core/scene/description.h"

namespace underact::scene {

/// The plane in which a scene is mirrored: that of its arm, arm::mirrorPlane().
arm::MirrorPlane mirrorPlaneOf(const Description& scene);

/// The scene reflected across the plane of its arm: for a stylus in the left hand. A stylus whose position and
/// orientation are reflected, R_WT -> S R_WT diag(1, -1, 1) with S the reflection (diag(-1, 1, 1) across x = 0), feels
/// the reflected force; so does an Omni with joints 1, 4 and 6 negated. Other arms stay as they are: their mirror image
/// is another arm, which may have other joints for the reflected pose. The loaded contents of a mesh or a curve stay:
/// its scale becomes negative. Twice is the scene itself, to the last bit, where the plane goes through the origin;
/// elsewhere within an ulp of twice its distance from there.
Description mirrored(Description scene);
/// Mirrors across any plane: of a scene whose arm has another one, and of a constraint alone.
Description mirrored(Description scene, const arm::MirrorPlane& plane);
Constraint mirrored(Constraint constraint, const arm::MirrorPlane& plane);

}  // namespace underact::scene
