#include "core/mesh_file/process.h"

#include "core/mesh_file/limits.h"
#include "core/mesh_file/message.h"

#if defined(__linux__)
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <ctime>

namespace underact::mesh_file {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kLook_ms = 10;  // how often cancel and the times are looked at

double secondsOf(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// That the process has computed so far.
double cpuOf(pid_t pid) {
  clockid_t clock{};
  timespec time{};
  if (::clock_getcpuclockid(pid, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return 0.0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Its id, or -errno.
pid_t spawn(const Errand& errand, int output_fd) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, errand.input_fd, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output_fd, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none{}, all{};
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&attributes, &none);  // whatever this thread blocks or ignores
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  std::string name = errand.program, argument = errand.argument;
  std::array<char*, 3> arguments{name.data(), argument.data(), nullptr};
  pid_t pid = -1;
  const int error = posix_spawn(&pid, errand.program.c_str(), &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? pid : -error;
}

/// Takes what the program writes, until it ends or must end.
class Listening {
 public:
  Listening(const Errand& errand, const mesh::Watch& watch, Answer& answer)
      : errand_(errand), watch_(watch), answer_(answer), block_(kBlock) {}

  Ending until(int fd, pid_t pid) {
    const Clock::time_point start = Clock::now();
    pollfd output{fd, POLLIN, 0};
    for (;;) {
      if (watch_.isCancelled()) return Ending::Cancelled;
      const double time_s = std::chrono::duration<double>(Clock::now() - start).count();
      if (time_s > errand_.most_time_s || cpuOf(pid) > errand_.most_cpu_s) return Ending::TookTooLong;
      if (::poll(&output, 1, kLook_ms) <= 0) continue;
      const ssize_t count = ::read(fd, block_.data(), block_.size());
      if (count == 0) return Ending::Exited;
      if (count < 0 && errno != EINTR) return Ending::Crashed;
      if (count > 0) take({block_.data(), static_cast<std::size_t>(count)});
      if (answer_.output.size() > errand_.most_output) return Ending::WroteTooMuch;
    }
  }

 private:
  void take(std::span<const std::byte> bytes) {
    while (answer_.output.empty() && !bytes.empty()) {
      const auto percent = std::to_integer<unsigned char>(bytes.front());
      if (percent == 0 || percent > kMostProgress) break;
      if (errand_.progress) errand_.progress(percent);
      bytes = bytes.subspan(1);
    }
    answer_.output.insert(answer_.output.end(), bytes.begin(), bytes.end());
  }
  const Errand& errand_;
  const mesh::Watch& watch_;
  Answer& answer_;
  std::vector<std::byte> block_;
};

}  // namespace

Answer run(const Errand& errand, const mesh::Watch& watch) {
  Answer answer;
  std::array<int, 2> pipe{-1, -1};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) {
    answer.code = errno;
    return answer;
  }
  ::fcntl(pipe[0], F_SETPIPE_SZ, static_cast<int>(4 * kBlock));
  const pid_t pid = spawn(errand, pipe[1]);
  ::close(pipe[1]);
  if (pid < 0) {
    ::close(pipe[0]);
    answer.code = -pid;
    return answer;
  }
  answer.ending = Listening(errand, watch, answer).until(pipe[0], pid);
  if (answer.ending != Ending::Exited) ::kill(pid, SIGKILL);
  ::close(pipe[0]);
  int status = 0;
  rusage usage{};
  while (::wait4(pid, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  answer.cpu_s = secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime);
  if (answer.ending == Ending::Exited && WIFSIGNALED(status)) answer.ending = Ending::Crashed;
  answer.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
  return answer;
}

}  // namespace underact::mesh_file

#else

namespace underact::mesh_file {

Answer run(const Errand&, const mesh::Watch&) {
  return {};
}

}  // namespace underact::mesh_file

#endif
