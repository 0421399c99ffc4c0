#pragma once
#include <string>

#include "core/base/result.h"
#include "core/scene/description.h"
#include "core/scene/teaching.h"

namespace underact::scene {

/// The scene as the text of a file, which readScene() reads back to the same description, to the last bit; keys with
/// default values are left out. teaching: text for a class.
std::string writeScene(const Description& scene, const std::optional<Teaching>& teaching = {});

/// Writes it beside path and renames it over path, so that a full disk loses nothing. Empty: no problem.
Problems writeSceneFile(const Description& scene, const std::string& path,
                        const std::optional<Teaching>& teaching = {});

}  // namespace underact::scene
