#pragma once
#include <sys/stat.h>

#include <string>

namespace underact::test {

/// This process's umask, until the end of the block.
class Umask {
 public:
  explicit Umask(mode_t mask) : before_(::umask(mask)) {}
  ~Umask() { ::umask(before_); }
  Umask(const Umask&) = delete;
  Umask& operator=(const Umask&) = delete;

 private:
  mode_t before_;
};

/// Who may do what with a file, 0644; 0: there is none.
inline unsigned modeOf(const std::string& path) {
  struct stat file {};
  return ::stat(path.c_str(), &file) == 0 ? file.st_mode & 07777U : 0U;
}

}  // namespace underact::test
