#pragma once
#include <sys/types.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace underact::test {

/// The processes of that name (its first 15 characters) that are children of another one.
inline std::vector<pid_t> childrenOf(pid_t parent, const std::string& name) {
  std::vector<pid_t> found;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", ignored)) {
    const std::string number = entry.path().filename();
    if (number.find_first_not_of("0123456789") != std::string::npos) continue;
    std::ifstream file(entry.path() / "stat");
    std::string line;          // PID (NAME) STATE PARENT ...
    std::getline(file, line);  // catches what an iterator over the buffer throws where the process has ended meanwhile
    const std::size_t open = line.find('('), close = line.rfind(')');
    if (open == std::string::npos || close == std::string::npos) continue;
    std::istringstream rest(line.substr(close + 1));
    char state = 0;
    pid_t of = -1;
    rest >> state >> of;
    if (of == parent && state != 'Z' && line.substr(open + 1, close - open - 1) == name.substr(0, 15))
      found.push_back(static_cast<pid_t>(std::stol(number)));
  }
  return found;
}

}  // namespace underact::test
