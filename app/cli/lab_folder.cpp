#include "app/cli/lab_folder.h"

#include <filesystem>
#include <fstream>
#include <ostream>

#include "app/cli/python.h"

namespace underact::cli {

Exit fillFolder(const std::string& folder, const std::string& kind,
                const std::vector<std::pair<std::string, const Table*>>& tables, const Streams& streams) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  for (const auto& [name, table] : tables) {
    if (table->isEmpty()) continue;
    const std::filesystem::path path = std::filesystem::path(folder) / name;
    std::ofstream file(path, std::ios::binary);
    table->printCsv(file);
    if (file.flush()) continue;
    streams.err << path.string() << ": This could not be written.\n";
    return Exit::File;
  }
  return runPython({"lab", kind, "--tables", folder, "--out", folder}, streams);
}

}  // namespace underact::cli
