#ifdef __linux__
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <filesystem>

#include "core/system/this_process.h"

#ifdef __GLIBC__  // known from the headers above
#include <malloc.h>
#endif

namespace underact::system {

std::string ownProgram() {
  std::error_code ignored;
  return std::filesystem::read_symlink("/proc/self/exe", ignored).string();
}

std::int64_t processId() {
  return ::getpid();
}

std::string uniqueWord() {
  static std::atomic<unsigned> count{0};
  return std::to_string(processId()) + "-" + std::to_string(count++);
}

std::string computerName() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "this-computer";
}

void setVariable(const char* name, const std::string& value) {
  value.empty() ? ::unsetenv(name) : ::setenv(name, value.c_str(), 1);
}

bool isTerminal(int descriptor) {
  return ::isatty(descriptor) != 0;
}

void end(int status) {
  ::_exit(status);
}

void lowerPriority(int more) {
  [[maybe_unused]] const int nice_now = ::nice(more);
}

void returnLargeBlocks() {
#ifdef __GLIBC__
  ::mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
}

}  // namespace underact::system
#endif
