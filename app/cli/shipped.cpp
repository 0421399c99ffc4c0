#include "app/cli/shipped.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "app/cli/python.h"

namespace underact::cli {

std::vector<std::string> shippedScenes() {
  namespace fs = std::filesystem;
  std::vector<fs::path> folders;
  if (const char* data = std::getenv("UNDERACT_DATA_DIR")) folders.push_back(fs::path(data) / "scenes");
  folders.push_back(fs::path(programFolder()) / "../share/underact/scenes");
  folders.push_back(fs::path(programFolder()) / "../../scenes");
  std::error_code error;
  for (const fs::path& folder : folders) {
    std::vector<std::string> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
      const fs::path& file = entry.path();
      if (file.extension() == ".json" && file.filename() != "scene.schema.json")
        files.push_back(fs::weakly_canonical(file, error).string());
    }
    std::sort(files.begin(), files.end());
    if (!files.empty()) return files;
  }
  return {};
}

}  // namespace underact::cli
