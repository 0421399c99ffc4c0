#pragma once
#include <string>

#include "core/base/result.h"
#include "core/scene/description.h"

namespace underact::scene {

/// The scene as a file that readScene() reads back to the same description, to the last bit; keys at their defaults
/// left out.
std::string writeScene(const Description& scene);

/// Writes it beside path and renames it over path, so that a full disk loses nothing. Empty: done.
Problems writeSceneFile(const Description& scene, const std::string& path);

}  // namespace underact::scene
