#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace underact::device::openhaptics {

/// The environment variable for the folder of the vendor driver's settings.
inline constexpr const char* kSettingsVariable = "GTDD_HOME";

/// The folder that holds the driver's `config`, if the driver would not find it by itself: in the home, otherwise
/// shared. Empty: there is none.
std::optional<std::string> settingsFolder(const std::filesystem::path& home, const std::filesystem::path& shared);

/// Where settings are kept on this machine.
std::filesystem::path homeFolder();
std::filesystem::path sharedFolder();

/// Sets the variable for this process if it is not set and there is such a folder. Before the driver is used; not while
/// other threads read the environment.
void pointToSettings();

}  // namespace underact::device::openhaptics
