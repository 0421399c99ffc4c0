#include "core/servo/guard.h"

#include <cstring>
#include <iterator>

#ifdef __linux__
#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <vector>

#include "core/base/places.h"
#include "core/base/translate.h"
#endif

namespace underact::servo {

#ifdef __linux__
namespace {

std::string hexOf(const std::string& bytes) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (const char byte : bytes) {
    const auto value = static_cast<unsigned char>(byte);
    text += {kDigits[value >> 4U], kDigits[value & 15U]};
  }
  return text;
}

/// The descriptors that are still to be closed here, whatever happens on the way.
struct Closing {
  ~Closing() {
    for (const int fd : fds) {
      if (fd >= 0) ::close(fd);
    }
  }
  std::vector<int> fds;
};

/// Far above the numbers that the guard uses, so that no dup2() overwrites one that is still needed.
int moveUp(int fd) {
  return ::fcntl(fd, F_DUPFD_CLOEXEC, 64);
}

int spawn(const std::string& program, int line_fd, int life_fd, int device_fd, std::int64_t limit_ns,
          const std::string& word) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, line_fd, kGuardLineFd);
  posix_spawn_file_actions_adddup2(&actions, life_fd, kGuardLifeFd);
  posix_spawn_file_actions_adddup2(&actions, device_fd, kGuardDeviceFd);
  posix_spawn_file_actions_addclosefrom_np(&actions, kGuardDeviceFd + 1);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID);  // a Ctrl+C or Ctrl+Z of the program is not the guard's
  std::string name = program, limit = std::to_string(limit_ns), hex = hexOf(word);
  std::array<char*, 4> arguments{name.data(), limit.data(), hex.data(), nullptr};
  pid_t pid = -1;
  const int error = posix_spawn(&pid, program.c_str(), &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? pid : -error;
}

}  // namespace

std::unique_ptr<Guard> Guard::start(const LastWord& word, std::int64_t limit_ns, const std::string& program,
                                    Sentence& why) {
  if (word.fd < 0) {
    why = said(QT_TRANSLATE_NOOP("problem", "this arm cannot be reached from outside the program"));
    return nullptr;
  }
  const Result<std::string> path = program.empty() ? findProgram("underact-guard") : program;
  if (!path) {
    why = path.problems().front().sentence;
    return nullptr;
  }
  std::unique_ptr<Guard> guard(new Guard);
  std::array<int, 2> life{-1, -1};
  guard->memory_fd_ = ::memfd_create("underact-guard", MFD_CLOEXEC);
  const bool has_memory = guard->memory_fd_ >= 0 && ::ftruncate(guard->memory_fd_, sizeof(GuardLine)) == 0;
  if (!has_memory || ::pipe2(life.data(), O_CLOEXEC) != 0) {
    why = std::strerror(errno);
    return nullptr;
  }
  guard->life_fd_ = life[1];
  void* memory = ::mmap(nullptr, sizeof(GuardLine), PROT_READ | PROT_WRITE, MAP_SHARED, guard->memory_fd_, 0);
  const Closing closing{{life[0], moveUp(guard->memory_fd_), moveUp(life[0]), moveUp(word.fd)}};
  if (memory == MAP_FAILED) {
    why = std::strerror(errno);
    return nullptr;
  }
  guard->line_ = new (memory) GuardLine;
  guard->pid_ = spawn(path.value(), closing.fds[1], closing.fds[2], closing.fds[3], limit_ns, word.bytes);
  if (guard->pid_ < 0) {
    why = std::strerror(-guard->pid_);
    return nullptr;
  }
  return guard;
}

Guard::~Guard() {
  if (life_fd_ >= 0) {
    if (line_ != nullptr) line_->farewell = 1;
    ::close(life_fd_);
  }
  if (pid_ > 0) {
    while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  if (line_ != nullptr) ::munmap(line_, sizeof(GuardLine));
  if (memory_fd_ >= 0) ::close(memory_fd_);
}

#else

std::unique_ptr<Guard> Guard::start(const LastWord&, std::int64_t, const std::string&, Sentence& why) {
  why = said(QT_TRANSLATE_NOOP("problem", "there is no guard on this system"));
  return nullptr;
}

Guard::~Guard() = default;

#endif

}  // namespace underact::servo
