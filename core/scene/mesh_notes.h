#pragma once
#include "core/base/result.h"
#include "core/scene/description.h"

namespace underact::scene {

/// What a person should know of the meshes of a scene that is in order: what crosses itself and what is felt there,
/// what was assumed, and a size that no hand can feel, or that no arm reaches. Each with its constraint's place. Of
/// meshes that were loaded by loadMeshes().
Problems meshNotes(const Description& scene);

}  // namespace underact::scene
