#include "device/openhaptics/settings.h"

#include <cstdlib>

#include "core/system/this_process.h"

namespace underact::device::openhaptics {

std::optional<std::string> settingsFolder(const std::filesystem::path& home, const std::filesystem::path& shared) {
  std::error_code ignored;
  for (const std::filesystem::path& folder : {home, shared}) {
    if (std::filesystem::is_directory(folder / "config", ignored)) return folder.string();
  }
  return {};
}

std::filesystem::path homeFolder() {
  const char* const home = std::getenv("HOME");
  return std::filesystem::path(home != nullptr ? home : "/") / ".3dsystems";
}

std::filesystem::path sharedFolder() {
  return "/usr/share/3DSystems";
}

void pointToSettings() {
  if (std::getenv(kSettingsVariable) != nullptr) return;
  if (const std::optional<std::string> folder = settingsFolder(homeFolder(), sharedFolder()))
    system::setVariable(kSettingsVariable, *folder);
}

}  // namespace underact::device::openhaptics
