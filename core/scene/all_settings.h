#pragma once
#include <string>
#include <vector>

#include "core/json/json.h"
#include "core/scene/settings.h"

namespace underact::scene {

// The settings of a scene for those who go through all of them, or have a value as a file has it.

/// The scene with another value at path, as withValue(), from a value as it stands in a file; null: none.
Result<Description> withFileValue(const Description& scene, const std::string& path, const json::Value& value);

/// Whether the value has an effect in the scene as it is: not the damping of a P law, nor the scene's control where
/// each constraint has its own. False, too, for a path without a setting.
bool appliesAt(const Description& scene, const std::string& path);

/// The paths of all settings that the scene has, in the order of the table: with numbers, and with the control of each
/// constraint, whether the file gives it one of its own or not.
std::vector<std::string> settingPaths(const Description& scene);

}  // namespace underact::scene
