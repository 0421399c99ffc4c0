#pragma once
#include <string>
#include <vector>

#include "core/json/json.h"
#include "core/scene/settings.h"

namespace underact::scene {

// The settings of a scene for those who go through all of them, or have a value as a file has it.

/// The scene with all of the values as they stand in a file, by their paths, in whatever order they are possible; null:
/// none. Problems: not many more than max_problems, of which the first max_hints name the nearest path where there is
/// none.
Result<Description> withFileValues(const Description& scene, const json::Value& values, std::size_t max_problems,
                                   std::size_t max_hints);

/// Whether the scene has a setting at the path.
bool hasSetting(const Description& scene, const std::string& path);

/// Whether the value has an effect in the scene as it is: not the damping of a P law, nor the scene's control where
/// each constraint has its own. False, too, for a path without a setting.
bool appliesAt(const Description& scene, const std::string& path);

/// The paths of all settings that the scene has, in the order of the table: with numbers, and with the control of each
/// constraint, whether the file gives it one of its own or not.
std::vector<std::string> settingPaths(const Description& scene);

}  // namespace underact::scene
