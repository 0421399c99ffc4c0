#include "app/cli/shipped.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "app/cli/python.h"

namespace underact::cli {
namespace {

/// name: of the folder where it is installed; in_sources: where it lies there.
std::vector<std::string> filesOf(const char* name, const char* in_sources) {
  namespace fs = std::filesystem;
  std::vector<fs::path> folders;
  if (const char* data = std::getenv("UNDERACT_DATA_DIR")) {
    folders.push_back(fs::path(data) / name);
    folders.push_back(fs::path(data) / in_sources);
  }
  folders.push_back(fs::path(programFolder()) / "../share/underact" / name);
  folders.push_back(fs::path(programFolder()) / "../.." / in_sources);
  std::error_code error;
  for (const fs::path& folder : folders) {
    std::vector<std::string> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
      const fs::path& file = entry.path();
      if (file.extension() == ".json" && file.stem().extension() != ".schema")
        files.push_back(fs::weakly_canonical(file, error).string());
    }
    std::sort(files.begin(), files.end());
    if (!files.empty()) return files;
  }
  return {};
}

}  // namespace

std::vector<std::string> shippedScenes() {
  return filesOf("scenes", "scenes");
}

std::vector<std::string> shippedLessons() {
  return filesOf("lessons", "resources/lessons");
}

std::string shippedSceneFolder() {
  const std::vector<std::string> scenes = shippedScenes();
  return scenes.empty() ? "" : std::filesystem::path(scenes.front()).parent_path().string();
}

}  // namespace underact::cli
