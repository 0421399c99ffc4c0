#pragma once
#include <string>

#include "core/scene/description.h"

namespace underact::scene {

/// The scene as it is written to file, an absolute path: meshes, curves and the file of its arm are named relative to
/// it, so that both can be moved together; by an absolute path where they are in an unrelated folder, or on another
/// disk.
Description namedFrom(Description scene, const std::string& file);

}  // namespace underact::scene
