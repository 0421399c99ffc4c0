#pragma once
#include <string>

#include "core/scene/description.h"

namespace underact::scene {

/// The scene as it is written to file, an absolute path: each mesh and curve is named relative to that file, so that
/// both can move together, or by its absolute path where it is far away on the disk, or on another one.
Description namedFrom(Description scene, const std::string& file);

}  // namespace underact::scene
