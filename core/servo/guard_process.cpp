#ifdef __linux__
#include "core/servo/guard_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <new>
#include <utility>

#include "core/system/clock.h"

namespace underact::servo {
namespace {

constexpr int kLeave_ms = 1000;  // in which a guard that was told to has left
constexpr int kLook_ms = 10;     // where the system has no descriptor of a process
// Far above the numbers that the guard uses, so that no dup2() overwrites one that is still needed.
constexpr int kFarUp = 64;

std::string hexOf(const std::string& bytes) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (const char byte : bytes) {
    const auto value = static_cast<unsigned char>(byte);
    text += {kDigits[value >> 4U], kDigits[value & 15U]};
  }
  return text;
}

void closeIfOpen(int& fd) {
  if (fd >= 0) ::close(fd);
  fd = -1;
}

int movedUp(int fd) {
  const int up = ::fcntl(fd, F_DUPFD_CLOEXEC, kFarUp);
  ::close(fd);
  return up;
}

/// Of its own session, so that a Ctrl+C or Ctrl+Z of the program is not the guard's; with no hold on the program's
/// terminal and pipes; and never real-time, whichever thread starts it.
int spawn(const std::string& program, const std::array<int, 3>& given, std::int64_t limit_ns, const std::string& word) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, fd, "/dev/null", O_RDWR, 0);
  posix_spawn_file_actions_adddup2(&actions, given[0], kGuardLineFd);
  posix_spawn_file_actions_adddup2(&actions, given[1], kGuardLifeFd);
  posix_spawn_file_actions_adddup2(&actions, given[2], kGuardDeviceFd);
  posix_spawn_file_actions_addclosefrom_np(&actions, kGuardDeviceFd + 1);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSCHEDULER);
  posix_spawnattr_setschedpolicy(&attributes, SCHED_OTHER);
  const sched_param normal{};
  posix_spawnattr_setschedparam(&attributes, &normal);
  std::string name = program, limit = std::to_string(limit_ns), hex = hexOf(word);
  std::array<char*, 4> arguments{name.data(), limit.data(), hex.data(), nullptr};
  pid_t pid = -1;
  const int error = posix_spawn(&pid, program.c_str(), &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? pid : -error;
}

}  // namespace

GuardProcess::GuardProcess(const LastWord& word, std::int64_t limit_ns, std::string program)
    : limit_ns_(limit_ns), program_(std::move(program)), word_(word.bytes) {
  std::array<int, 2> life{-1, -1};
  // A guard that comes later gets this arm, too, and never what has its number by then.
  device_fd_ = ::fcntl(word.fd, F_DUPFD_CLOEXEC, kFarUp);
  memory_fd_ = ::memfd_create("underact-guard", MFD_CLOEXEC);
  const bool has_memory = memory_fd_ >= 0 && ::ftruncate(memory_fd_, sizeof(GuardLine)) == 0;
  if (device_fd_ < 0 || !has_memory || ::pipe2(life.data(), O_CLOEXEC) != 0) {
    failure_ = errno;
    return;
  }
  memory_fd_ = movedUp(memory_fd_);
  watched_fd_ = movedUp(life[0]);
  life_fd_ = life[1];
  void* memory = ::mmap(nullptr, sizeof(GuardLine), PROT_READ | PROT_WRITE, MAP_SHARED, memory_fd_, 0);
  if (memory == MAP_FAILED) {
    failure_ = errno;
    return;
  }
  line_ = new (memory) GuardLine;
}

GuardProcess::~GuardProcess() {
  if (line_ != nullptr) line_->farewell = 1;
  closeIfOpen(life_fd_);
  if (!waitForEnd(kLeave_ms)) {  // stopped, or held up by the arm: it must not hold up the program
    kill();
    waitForEnd(-1);
  }
  closeIfOpen(end_fd_);
  closeIfOpen(watched_fd_);
  closeIfOpen(memory_fd_);
  closeIfOpen(device_fd_);
  if (line_ != nullptr) ::munmap(line_, sizeof(GuardLine));
}

bool GuardProcess::start() {
  const int pid = spawn(program_, {memory_fd_, watched_fd_, device_fd_}, limit_ns_, word_);
  if (pid < 0) {
    failure_ = -pid;
    return false;
  }
  pid_ = pid;
  end_fd_ = static_cast<int>(::syscall(SYS_pidfd_open, pid, 0));  // Linux 5.3
  return true;
}

bool GuardProcess::hasEnded() {
  if (pid_ < 0) return true;
  const pid_t gone = ::waitpid(pid_, nullptr, WNOHANG);
  if (gone == 0 || (gone < 0 && errno == EINTR)) return false;
  pid_ = -1;
  closeIfOpen(end_fd_);
  return true;
}

void GuardProcess::kill() {
  if (pid_ > 0) ::kill(pid_, SIGKILL);
}

/// time_ms below 0: as long as it takes.
bool GuardProcess::waitForEnd(int time_ms) {
  const std::int64_t end_ns = system::monotonicNow_ns() + std::int64_t{time_ms} * 1'000'000;
  while (!hasEnded()) {
    if (time_ms >= 0 && system::monotonicNow_ns() >= end_ns) return false;
    pollfd end{end_fd_, POLLIN, 0};
    ::poll(&end, 1, kLook_ms);
  }
  return true;
}

}  // namespace underact::servo
#endif
