#include "app/cli/shipped.h"

#include <algorithm>
#include <filesystem>

#include "core/system/resource_paths.h"

namespace underact::cli {
namespace {

Result<std::vector<std::string>> filesOf(system::Resource resource) {
  const Result<std::string> folder = system::findResource(resource);
  if (!folder) return folder.problems();
  std::vector<std::string> files;
  std::error_code error;
  for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(folder.value(), error)) {
    const std::filesystem::path& file = entry.path();
    if (file.extension() == ".json" && file.stem().extension() != ".schema") files.push_back(file.string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

Result<std::vector<std::string>> shippedScenes() {
  return filesOf(system::Resource::Scenes);
}

Result<std::vector<std::string>> shippedLessons() {
  return filesOf(system::Resource::Lessons);
}

}  // namespace underact::cli
