#pragma once
#include "core/base/result.h"
#include "core/scene/description.h"

namespace underact::scene {

/// What is worth knowing about a valid scene: rotations of few decimals, and of its meshes which intersect themselves
/// and what is felt there, what was assumed, and sizes that a hand cannot feel or the arm cannot reach. Each with the
/// place of its constraint. Then which meshes of the arm's own picture are not drawn, each with its place in the arm's
/// file. scene: with its meshes loaded by loadMeshes().
Problems meshNotes(const Description& scene);

}  // namespace underact::scene
