#pragma once
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/scene/description.h"
#include "core/scene/scene_arm.h"

namespace underact::scene {

/// A scene from JSON text that compile() accepts; or all problems at once, each with line, column and key. file_name:
/// for the places. Unknown keys are problems (with the nearest known key suggested). An arm that the scene names by its
/// file is read, too (readSceneArm()).
Result<Description> readScene(std::string_view text, const std::string& file_name, NamedFiles files = NamedFiles::Open);

/// Reads a scene from a file of at most 16 MiB; a file that cannot be read is a problem with line 0.
Result<Description> readSceneFile(const std::string& path);

/// Problems between keys (a zero gain beside others with the weighted metric, say). readScene() has called it; an
/// editor calls it before compile(). Empty: compile() accepts the scene.
Problems check(const Description& scene);

}  // namespace underact::scene
