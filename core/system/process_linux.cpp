#ifdef __linux__
#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <ctime>

#include "core/system/process.h"

namespace underact::system {
namespace {

constexpr int kPoll_ms = 10;  // on systems without process descriptors

double secondsOf(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Sets the attributes of a new process, whatever this thread blocks or ignores and, if is_apart, whatever its
/// scheduling.
void setAttributes(posix_spawnattr_t& attributes, bool is_apart) {
  sigset_t none{}, all{};
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  const sched_param normal{};
  posix_spawnattr_setschedpolicy(&attributes, SCHED_OTHER);
  posix_spawnattr_setschedparam(&attributes, &normal);
  constexpr int kAlways = POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF;
  constexpr int kApart = POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSCHEDULER;
  posix_spawnattr_setflags(&attributes, static_cast<short>(is_apart ? kAlways | kApart : kAlways));
}

End endOf(int status, const rusage& usage) {
  const bool by_signal = WIFSIGNALED(status);
  return {by_signal, by_signal ? WTERMSIG(status) : WEXITSTATUS(status),
          secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime)};
}

}  // namespace

Process::Process(const Launch& launch) {
  const int numbers = std::max(static_cast<int>(launch.given.size()), kErrors + 1);
  std::vector<Descriptor> copies;  // above its numbers: otherwise a later one could replace it
  for (const int given : launch.given) {
    copies.emplace_back(given < 0 ? -1 : ::fcntl(given, F_DUPFD_CLOEXEC, numbers));
    if (given < 0 || copies.back().isOpen()) continue;
    error_ = errno;  // otherwise it would get the one of this program
    return;
  }
  copies.resize(static_cast<std::size_t>(numbers));
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (int number = 0; number < numbers; ++number) {
    const Descriptor& copy = copies[static_cast<std::size_t>(number)];
    if (copy.isOpen()) {
      posix_spawn_file_actions_adddup2(&actions, copy.number(), number);
    } else {
      posix_spawn_file_actions_addopen(&actions, number, "/dev/null", O_RDWR, 0);
    }
  }
  posix_spawn_file_actions_addclosefrom_np(&actions, numbers);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  setAttributes(attributes, launch.is_apart);
  std::vector<std::string> words{launch.program};
  words.insert(words.end(), launch.arguments.begin(), launch.arguments.end());
  pid_t id = -1;
  error_ = posix_spawn(&id, words.front().c_str(), &actions, &attributes, pointersTo(words).data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error_ != 0) return;
  id_ = id;
  ending_ = Descriptor(static_cast<int>(::syscall(SYS_pidfd_open, id, 0)));  // Linux 5.3
}

Process::~Process() {
  kill();
  waitForEnd(-1);
}

bool Process::hasEnded() {
  if (id_ < 0) return true;
  int status = 0;
  rusage usage{};
  const pid_t gone = ::wait4(id_, &status, WNOHANG, &usage);
  if (gone == 0 || (gone < 0 && errno == EINTR)) return false;
  id_ = -1;
  ending_ = {};
  end_ = endOf(status, usage);
  return true;
}

bool Process::waitForEnd(int time_ms) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(time_ms);
  while (!hasEnded()) {
    if (time_ms >= 0 && std::chrono::steady_clock::now() >= until) return false;
    pollfd end{ending_.number(), POLLIN, 0};
    ::poll(&end, 1, kPoll_ms);
  }
  return true;
}

void Process::kill() const {
  if (id_ > 0) ::kill(id_, SIGKILL);
}

double Process::cpuSoFar_s() const {
  clockid_t clock{};
  timespec time{};
  if (id_ <= 0 || ::clock_getcpuclockid(id_, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return 0.0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::optional<End> runHere(std::vector<std::string> words, const char* variable) {
  const std::string without = std::string(variable) + "=";
  std::vector<std::string> environment;
  for (char** one = environ; *one != nullptr; ++one) {
    if (!std::string_view(*one).starts_with(without)) environment.emplace_back(*one);
  }
  pid_t id = 0;
  errno = posix_spawnp(&id, words.front().c_str(), nullptr, nullptr, pointersTo(words).data(),
                       pointersTo(environment).data());
  if (errno != 0) return {};
  int status = 0;
  rusage usage{};
  while (::wait4(id, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  return endOf(status, usage);
}

void leadGroup(int more) {
  ::setpgid(0, 0);
  ::setpriority(PRIO_PROCESS, 0, more);
}

void killGroup(std::int64_t process) {
  ::kill(-static_cast<pid_t>(process), SIGKILL);
}

}  // namespace underact::system
#endif
