#pragma once
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/comes.h"
#include "tests/support/scratch_folder.h"

namespace underact::test {

inline bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

/// underact-cli as a process, with keys of its own; what it says goes to a file.
class Process {
 public:
  Process(const ScratchFolder& scratch, const std::string& name, std::vector<std::string> arguments)
      : file_(scratch.file(name)) {
    const std::string keys = scratch.path() + "/keys", path = std::string(UNDERACT_BINARY) + "/underact-cli";
    arguments.insert(arguments.begin(), path);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    const int out = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    id_ = fork();
    if (id_ == 0) {
      setenv("UNDERACT_KEYS", keys.c_str(), 1);
      dup2(out, STDOUT_FILENO);
      dup2(out, STDERR_FILENO);
      execv(path.c_str(), argv.data());
      _exit(127);
    }
    close(out);
  }
  ~Process() {
    if (id_ > 0) {
      ::kill(id_, SIGKILL);
      end();
    }
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  std::string output() const {
    std::ifstream file(file_);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  bool says(const std::string& words) const {
    return comes([&] { return test::says(output(), words); });
  }
  void kill(int signal) const { ::kill(id_, signal); }
  /// Its exit status; below 0: a signal ended it.
  int end() {
    int status = 0;
    waitpid(id_, &status, 0);
    id_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  std::string file_;
  pid_t id_ = -1;
};

}  // namespace underact::test
