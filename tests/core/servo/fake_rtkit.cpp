#include "tests/core/servo/fake_rtkit.h"

#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <systemd/sd-bus.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <future>

extern char** environ;

namespace underact::test {
namespace {

constexpr const char* kService = "org.freedesktop.RealtimeKit1";

/// What comes through the descriptor up to the end of the line.
std::string lineFrom(int fd) {
  std::string line;
  for (char one = 0; read(fd, &one, 1) == 1 && one != '\n';) line += one;
  return line;
}

}  // namespace

bool PrivateBus::isPossible() {
  return std::system("command -v dbus-daemon >/dev/null 2>&1") == 0;
}

PrivateBus::PrivateBus() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return;
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, ends[1], 3);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);  // it complains of small limits
  std::array<const char*, 6> words{"dbus-daemon", "--session", "--nofork", "--nopidfile", "--print-address=3", nullptr};
  const bool started =
      posix_spawnp(&pid_, words[0], &files, nullptr, const_cast<char* const*>(words.data()), environ) == 0;
  posix_spawn_file_actions_destroy(&files);
  close(ends[1]);
  if (started) address_ = lineFrom(ends[0]);
  close(ends[0]);
  if (!started) pid_ = -1;
}

PrivateBus::~PrivateBus() {
  if (pid_ < 0) return;
  kill(pid_, SIGTERM);
  waitpid(pid_, nullptr, 0);
}

SystemBusAt::SystemBusAt(const std::string& address) {
  if (const char* before = std::getenv("DBUS_SYSTEM_BUS_ADDRESS")) before_ = before;
  setenv("DBUS_SYSTEM_BUS_ADDRESS", address.c_str(), 1);
}

SystemBusAt::~SystemBusAt() {
  before_ ? setenv("DBUS_SYSTEM_BUS_ADDRESS", before_->c_str(), 1) : unsetenv("DBUS_SYSTEM_BUS_ADDRESS");
}

struct FakeRtkit::Impl {
  explicit Impl(const Rtkit& wanted) : behaviour(wanted) {}

  static int onCall(sd_bus_message* call, void* self, sd_bus_error* error) {
    return static_cast<Impl*>(self)->answer(call, error);
  }

  int answer(sd_bus_message* call, sd_bus_error* error) {
    if (sd_bus_message_is_method_call(call, "org.freedesktop.DBus.Properties", "Get") > 0)
      return answerGet(call, error);
    if (sd_bus_message_is_method_call(call, kService, "MakeThreadRealtime") > 0) return answerMake(call, error);
    return 0;
  }

  int answerGet(sd_bus_message* call, sd_bus_error* error) const {
    const char *interface = nullptr, *property = nullptr;
    if (const int code = sd_bus_message_read(call, "ss", &interface, &property); code < 0) return code;
    if (property == std::string("MaxRealtimePriority"))
      return sd_bus_reply_method_return(call, "v", "i", behaviour.max_priority);
    if (property == std::string("RTTimeUSecMax"))
      return sd_bus_reply_method_return(call, "v", "x", behaviour.longest_us);
    return sd_bus_error_set(error, "org.freedesktop.DBus.Error.UnknownProperty", property);
  }

  int answerMake(sd_bus_message* call, sd_bus_error* error) {
    const std::lock_guard lock(mutex);
    if (const int code = sd_bus_message_read(call, "tu", &asked.thread, &asked.priority); code < 0) return code;
    ++asked.calls;
    getrlimit(RLIMIT_RTTIME, &asked.rest);
    if (!behaviour.answers) return 1;
    if (behaviour.refuses)
      return sd_bus_error_set(error, "org.freedesktop.DBus.Error.AccessDenied", "Too many threads already");
    if (behaviour.acts) {
      const sched_param wanted{static_cast<int>(asked.priority)};
      asked.is_held =
          sched_setscheduler(static_cast<pid_t>(asked.thread), SCHED_RR | SCHED_RESET_ON_FORK, &wanted) != 0;
    }
    return sd_bus_reply_method_return(call, "");
  }

  void serve(const std::string& address, std::promise<void> ready) {
    sd_bus* bus = nullptr;
    sd_bus_new(&bus);
    sd_bus_set_address(bus, address.c_str());
    sd_bus_set_bus_client(bus, 1);
    sd_bus_start(bus);
    sd_bus_add_object(bus, nullptr, "/org/freedesktop/RealtimeKit1", &Impl::onCall, this);
    sd_bus_request_name(bus, kService, 0);
    ready.set_value();
    while (!ends) {
      int code = 1;
      while (code > 0) code = sd_bus_process(bus, nullptr);
      if (code < 0 || sd_bus_wait(bus, 50'000) < 0) break;
    }
    sd_bus_flush_close_unref(bus);
  }

  Rtkit behaviour;
  std::atomic<bool> ends{false};
  mutable std::mutex mutex;
  Asked asked;
  std::thread thread;
};

FakeRtkit::FakeRtkit(const std::string& address, const Rtkit& behaviour) : impl_(std::make_unique<Impl>(behaviour)) {
  std::promise<void> ready;
  std::future<void> is_ready = ready.get_future();
  impl_->thread =
      std::thread([this, address, ready = std::move(ready)]() mutable { impl_->serve(address, std::move(ready)); });
  is_ready.get();
}

FakeRtkit::~FakeRtkit() {
  impl_->ends = true;
  impl_->thread.join();
}

FakeRtkit::Asked FakeRtkit::asked() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->asked;
}

}  // namespace underact::test
