#include "core/base/program.h"

#include <cstdlib>
#include <filesystem>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif
#ifdef __APPLE__
#include <mach-o/dyld.h>

#include <array>
#include <cstdint>
#endif

namespace underact {
namespace {

namespace fs = std::filesystem;

bool isProgram(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return false;
#if defined(__unix__) || defined(__APPLE__)
  return ::access(path.c_str(), X_OK) == 0;
#else
  return true;
#endif
}

/// The folder of the running program.
fs::path hereFolder() {
  std::error_code ignored;
#ifdef __APPLE__
  std::array<char, 4096> path{};
  auto size = static_cast<std::uint32_t>(path.size());
  return _NSGetExecutablePath(path.data(), &size) == 0 ? fs::path(path.data()).parent_path() : fs::path();
#else
  return fs::read_symlink("/proc/self/exe", ignored).parent_path();
#endif
}

}  // namespace

std::string helperProgram(const std::string& name, const char* variable) {
  const char* stated = variable == nullptr ? nullptr : std::getenv(variable);
  if (stated != nullptr && *stated != '\0') return isProgram(stated) ? stated : std::string();
  const fs::path here = hereFolder();
  for (const fs::path& place : {here / name, here / ".." / name, here / "../libexec/underact" / name}) {
    if (isProgram(place)) return place.string();
  }
  return {};
}

}  // namespace underact
