#include "app/cli/python.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <ostream>

#include "app/cli/scene_file.h"
#include "core/base/places.h"

namespace underact::cli {
namespace {

/// Debian's, where there is one: it is the one that has Debian's libraries.
std::string interpreter() {
  const char* const chosen = std::getenv("UNDERACT_PYTHON");
  if (chosen != nullptr && *chosen != '\0') return chosen;
  return access("/usr/bin/python3", X_OK) == 0 ? "/usr/bin/python3" : "python3";
}

/// This program's environment, with the package where Python looks.
std::vector<std::string> environmentWith(const std::string& package) {
  std::vector<std::string> all{"PYTHONPATH=" + package};
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

Exit runPython(const std::vector<std::string>& arguments, const Streams& streams) {
  const Result<std::string> package = findResource(Resource::Python);
  if (!package) return fail(package.problems(), Exit::File, streams);
  streams.out.flush();
  std::vector<std::string> words{interpreter(), "-m", "underact"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> environment = environmentWith(package.value());
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
