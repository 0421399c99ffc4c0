#ifdef __linux__
#include <pthread.h>
#include <sched.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "core/system/thread_priority.h"

namespace underact::system {
namespace {

constexpr int kBelowServo = 79;

}  // namespace

std::optional<ThreadPriority> grantedPriority() {
  bool is_granted = false;
  std::thread([&is_granted] { is_granted = setOwnPriority({SCHED_FIFO, kBelowServo}); }).join();
  if (!is_granted) return {};
  return ThreadPriority{SCHED_FIFO, kBelowServo};
}

ThreadPriority ownPriority() {
  ThreadPriority own;
  sched_param is{};
  if (pthread_getschedparam(pthread_self(), &own.policy, &is) == 0) own.priority = is.sched_priority;
  return own;
}

bool setOwnPriority(const ThreadPriority& wanted) {
  sched_param given{};
  given.sched_priority = wanted.priority;
  return pthread_setschedparam(pthread_self(), wanted.policy, &given) == 0;
}

void setThreadPriority(const std::string& thread_name, bool on) {
  std::error_code failed;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task", failed)) {
    std::ifstream file(task.path() / "comm");
    std::string name;
    if (!std::getline(file, name) || name != thread_name) continue;
    sched_param wanted{};
    wanted.sched_priority = on ? kBelowServo : 0;
    sched_setscheduler(std::stoi(task.path().filename()), on ? SCHED_FIFO : SCHED_OTHER, &wanted);
  }
}

}  // namespace underact::system
#endif
