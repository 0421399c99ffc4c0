#include "app/cli/python.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <ostream>

namespace underact::cli {
namespace {

namespace fs = std::filesystem;

/// Where the package lies: beside an installed program, or in the source tree that this one was built from.
fs::path packageFolder() {
  std::vector<fs::path> folders;
  if (const char* data = std::getenv("UNDERACT_DATA_DIR")) folders.push_back(fs::path(data) / "python");
  const fs::path program = programFolder();
  folders.push_back(program / "../share/underact/python");
  folders.push_back(program / "../lib/python3/dist-packages");  // where Debian has it
  folders.push_back(program / "../../app/python");
  std::error_code error;
  for (const fs::path& folder : folders) {
    if (fs::exists(folder / "underact", error)) return fs::weakly_canonical(folder, error);
  }
  return {};
}

/// Debian's, where there is one: it is the one that has Debian's libraries.
std::string interpreter() {
  if (const char* chosen = std::getenv("UNDERACT_PYTHON")) return chosen;
  return access("/usr/bin/python3", X_OK) == 0 ? "/usr/bin/python3" : "python3";
}

/// This program's environment, with the package where Python looks.
std::vector<std::string> environmentWith(const fs::path& package) {
  std::vector<std::string> all{"PYTHONPATH=" + package.string()};
  for (char** one = environ; *one != nullptr; ++one) {
    if (std::strncmp(*one, "PYTHONPATH=", 11) != 0) all.emplace_back(*one);
  }
  return all;
}

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

}  // namespace

std::string programFolder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? std::string() : program.parent_path().string();
}

Exit runPython(const std::vector<std::string>& arguments, const Streams& streams) {
  const fs::path package = packageFolder();
  if (package.empty()) {
    streams.err
        << "The Python package that ships with Underact was not found beside the program. Set UNDERACT_DATA_DIR "
           "to the folder that holds it.\n";
    return Exit::File;
  }
  streams.out.flush();
  std::vector<std::string> words{interpreter(), "-m", "underact"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> environment = environmentWith(package);
  pid_t child = 0;
  const int failed = posix_spawnp(&child, words.front().c_str(), nullptr, nullptr, pointersTo(words).data(),
                                  pointersTo(environment).data());
  if (failed != 0) {
    streams.err << "Python could not be started (" << words.front() << "): " << std::strerror(failed)
                << ". Install python3, python3-h5py and python3-matplotlib, or set UNDERACT_PYTHON.\n";
    return Exit::File;
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? static_cast<Exit>(WEXITSTATUS(status)) : Exit::File;
}

}  // namespace underact::cli
