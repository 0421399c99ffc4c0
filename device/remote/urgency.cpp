#include "device/remote/urgency.h"

#ifdef __linux__
#include <pthread.h>
#include <sched.h>

#include <filesystem>
#include <fstream>
#include <thread>
#endif

namespace underact::device::remote {

#ifdef __linux__
namespace {

constexpr int kPriority = 79;

}  // namespace

std::optional<Urgency> urgencyGranted() {
  bool is_granted = false;
  std::thread([&is_granted] {
    sched_param wanted{};
    wanted.sched_priority = kPriority;
    is_granted = pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted) == 0;
  }).join();
  if (!is_granted) return {};
  return Urgency{SCHED_FIFO, kPriority};
}

Urgency ownUrgency() {
  Urgency own;
  sched_param is{};
  if (pthread_getschedparam(pthread_self(), &own.policy, &is) == 0) own.priority = is.sched_priority;
  return own;
}

bool setOwnUrgency(const Urgency& wanted) {
  sched_param given{};
  given.sched_priority = wanted.priority;
  return pthread_setschedparam(pthread_self(), wanted.policy, &given) == 0;
}

void setUrgency(const std::string& thread_name, bool on) {
  std::error_code failed;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task", failed)) {
    std::ifstream file(task.path() / "comm");
    std::string name;
    if (!std::getline(file, name) || name != thread_name) continue;
    sched_param wanted{};
    wanted.sched_priority = on ? kPriority : 0;
    sched_setscheduler(std::stoi(task.path().filename()), on ? SCHED_FIFO : SCHED_OTHER, &wanted);
  }
}

#else

std::optional<Urgency> urgencyGranted() {
  return {};
}
Urgency ownUrgency() {
  return {};
}
bool setOwnUrgency(const Urgency& /*wanted*/) {
  return true;
}
void setUrgency(const std::string& /*thread_name*/, bool /*on*/) {}

#endif

}  // namespace underact::device::remote
