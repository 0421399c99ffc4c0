#pragma once
#include <string>

#include "core/scene/description.h"

namespace underact::scene {

/// The scene as it is written to file, an absolute path: each mesh and curve is named as seen from there, so that both
/// can move together; by its whole path where it is in quite another place of the disk, or on another one.
Description namedFrom(Description scene, const std::string& file);

}  // namespace underact::scene
