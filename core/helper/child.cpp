#include "core/helper/child.h"

#include <system_error>

#include "core/base/translate.h"

#if defined(__linux__)
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <ctime>
#endif

namespace underact::helper {

#if defined(__linux__)
namespace {

double secondsOf(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

constexpr int kLooksForEnd = 10'000;  // 2 s in all
constexpr useconds_t kLookForEnd_us = 200;

/// A copy beyond the numbers that the process gets: one of these given as another would be closed by it.
int outOfTheWay(int fd) {
  return fd < 0 ? -1 : ::fcntl(fd, F_DUPFD_CLOEXEC, kFile + 1);
}

/// Its id, or -errno.
pid_t spawn(const Start& start, const std::array<int, 3>& fds) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (fds[0] >= 0) posix_spawn_file_actions_adddup2(&actions, fds[0], STDIN_FILENO);
  if (fds[1] >= 0) posix_spawn_file_actions_adddup2(&actions, fds[1], STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  if (fds[2] >= 0) posix_spawn_file_actions_adddup2(&actions, fds[2], kFile);
  posix_spawn_file_actions_addclosefrom_np(&actions, fds[2] >= 0 ? kFile + 1 : kFile);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none{}, all{};
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&attributes, &none);  // whatever this thread blocks or ignores
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  std::string name = start.program, argument = start.argument;
  std::array<char*, 3> arguments{name.data(), argument.data(), nullptr};
  pid_t pid = -1;
  const int error = posix_spawn(&pid, start.program.c_str(), &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? pid : -error;
}

}  // namespace

Child::Child(const Start& start) {
  const std::array wanted{start.input_fd, start.output_fd, start.file_fd};
  std::array<int, 3> fds{-1, -1, -1};
  for (std::size_t index = 0; index < wanted.size() && error_ == 0; ++index) {
    fds[index] = outOfTheWay(wanted[index]);
    if (wanted[index] >= 0 && fds[index] < 0) error_ = errno;  // without its own it would have this program's
  }
  if (error_ == 0) {
    pid_ = spawn(start, fds);
    if (pid_ < 0) error_ = -pid_;
  }
  for (const int fd : fds) {
    if (fd >= 0) ::close(fd);
  }
}

double Child::cpuSoFar_s() const {
  clockid_t clock{};
  timespec time{};
  if (pid_ <= 0 || ::clock_getcpuclockid(pid_, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return 0.0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Ending Child::end(Ending ending) {
  const pid_t pid = std::exchange(pid_, -1);
  if (pid <= 0) return Ending::NotStarted;
  int status = 0;
  rusage usage{};
  // One that has closed its output and goes on is not waited for without end.
  pid_t ended = 0;
  for (int look = 0; ending == Ending::Exited && look < kLooksForEnd && ended == 0; ++look) {
    ended = ::wait4(pid, &status, WNOHANG, &usage);
    if (ended == 0) ::usleep(kLookForEnd_us);
  }
  if (ended == 0) ::kill(pid, SIGKILL);
  while (ended <= 0 && (ended = ::wait4(pid, &status, 0, &usage)) < 0 && errno == EINTR) {
  }
  cpu_s_ = secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime);
  code_ = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
  if (ending != Ending::Exited) return ending;
  return WIFSIGNALED(status) ? Ending::Crashed : code_ == kNotSealed ? Ending::NotSealed : Ending::Exited;
}

#else

Child::Child(const Start&) {}

double Child::cpuSoFar_s() const {
  return 0.0;
}

Ending Child::end(Ending) {
  return Ending::NotStarted;
}

#endif

std::string secondsText(double s) {
  const int tenths = static_cast<int>(s * 10.0);
  return s < 10.0 ? std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " s"
                  : std::to_string(static_cast<int>(s)) + " s";
}

Sentence whyWaited(double most_time_s) {
  return said(TRANSLATE_NOOP("problem",
                             "The file could not be read within %1, though its reader had little to do: its disk or "
                             "the network may be slow. Copy it to this computer, and open the copy."),
              {secondsText(most_time_s)});
}

Sentence whyNoHelper(Ending ending, const std::string& program, int error) {
  if (ending == Ending::NotStarted)
    return said(TRANSLATE_NOOP("problem", "%1 cannot be started: %2."),
                {program, std::generic_category().message(error)});
  if (ending == Ending::NotSealed)
    return said(TRANSLATE_NOOP("problem",
                               "The file was not opened: %1 could not be shut off from the rest of this computer, "
                               "which protects you from what a damaged or malicious file may do. Run the program "
                               "where system calls may be filtered (seccomp)."),
                {program});
  return {};
}

}  // namespace underact::helper
