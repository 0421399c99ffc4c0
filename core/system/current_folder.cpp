#include "core/system/current_folder.h"

#include <cstdlib>

#include "core/system/this_process.h"

namespace underact::system {
namespace {

/// The variables by which programs, Python, Qt, VTK, HDF5, OpenGL and GTK (for Qt's styles on some desktops) find code.
constexpr const char* kLists[] = {"PATH",
                                  "LD_LIBRARY_PATH",
                                  "PYTHONPATH",
                                  "PYTHONHOME",
                                  "PYTHONUSERBASE",
                                  "QT_PLUGIN_PATH",
                                  "QT_QPA_PLATFORM_PLUGIN_PATH",
                                  "VTK_AUTOLOAD_PATH",
                                  "HDF5_PLUGIN_PATH",
                                  "LIBGL_DRIVERS_PATH",
                                  "GTK_PATH",
                                  "GIO_EXTRA_MODULES"};
constexpr const char* kPlainPath = "/usr/local/bin:/usr/bin:/bin";  // if nothing else is left of PATH

}  // namespace

std::string absoluteFolders(std::string_view list) {
  std::string kept;
  while (!list.empty()) {
    const std::string_view folder = list.substr(0, list.find(':'));
    list.remove_prefix(folder.size() == list.size() ? folder.size() : folder.size() + 1);
    if (!folder.starts_with('/')) continue;
    if (!kept.empty()) kept += ':';
    kept += folder;
  }
  return kept;
}

void keepOutCurrentFolder() {
  for (const char* const name : kLists) {
    const char* const list = std::getenv(name);
    if (list == nullptr) continue;
    const std::string kept = absoluteFolders(list);
    if (!kept.empty() && kept == list) continue;
    setVariable(name, kept.empty() && std::string_view(name) == "PATH" ? kPlainPath : kept);
  }
}

}  // namespace underact::system
