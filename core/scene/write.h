#pragma once
#include <string>

#include "core/base/result.h"
#include "core/scene/description.h"
#include "core/scene/teaching.h"

namespace underact::scene {

/// The scene as a file that readScene() reads back to the same description, to the last bit; keys at their defaults are
/// left out. teaching: what a class reads about it.
std::string writeScene(const Description& scene, const std::optional<Teaching>& teaching = {});

/// Writes beside path, then renames over path, so that a full disk loses nothing. Empty: done.
Problems writeSceneFile(const Description& scene, const std::string& path,
                        const std::optional<Teaching>& teaching = {});

}  // namespace underact::scene
