#pragma once
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/scene/description.h"

namespace underact::scene {

/// A scene from JSON text, checked completely: every problem at once, each with line, column and key, or a scene that
/// compile() accepts. file_name: for the places. Unknown keys are problems (with the nearest known key suggested).
Result<Description> readScene(std::string_view text, const std::string& file_name);

/// The same from a file of at most 16 MiB; a file that cannot be read is a problem with line 0.
Result<Description> readSceneFile(const std::string& path);

/// Problems that no single key has: they lie between keys (a zero gain beside others with the weighted metric, for
/// example). readScene() has called it; an editor calls it before compile(). Empty: compile() accepts the scene.
Problems check(const Description& scene);

}  // namespace underact::scene
