#ifdef __linux__
#include <sys/utsname.h>

#include <fstream>
#include <thread>

#include "core/system/machine.h"

#ifdef __GLIBC__
#include <gnu/libc-version.h>
#endif

namespace underact::system {
namespace {

/// What stands behind the first of these keys in /proc/cpuinfo: which one there is depends on the architecture.
std::string processorName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("model name") && !line.starts_with("Model") && !line.starts_with("cpu model")) continue;
    const std::size_t at = line.find_first_not_of(" \t", line.find(':') + 1);
    return at == std::string::npos ? std::string() : line.substr(at);
  }
  return {};
}

}  // namespace

Machine thisMachine() {
  Machine machine;
  machine.processor = processorName();
  machine.cores = static_cast<int>(std::thread::hardware_concurrency());
  utsname names{};
  if (::uname(&names) == 0) {
    machine.kernel = std::string(names.sysname) + " " + names.release;
    machine.architecture = names.machine;
  }
#ifdef __GLIBC__
  machine.c_library = std::string("glibc ") + ::gnu_get_libc_version();
#endif
  return machine;
}

}  // namespace underact::system
#endif
