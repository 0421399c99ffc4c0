#include <algorithm>
#include <chrono>

#include "tests/openhaptics/hd/library.h"

namespace underact::test::hd {

bool Library::setRate(unsigned long rate_hz) {
  constexpr std::array<unsigned long, 5> kRates{500, 1000, 1600, 2000, 4000};
  if (std::find(kRates.begin(), kRates.end(), rate_hz) == kRates.end()) return false;
  rate_hz_ = static_cast<int>(rate_hz);
  return true;
}

unsigned long Library::schedule(Callback callback, void* self, std::uint16_t priority) {
  const unsigned long handle = next_handle_++;
  tasks_[handle] = {handle, callback, self, priority};
  return handle;
}

void Library::unschedule(unsigned long handle) {
  if (tasks_.erase(handle) == 0) push(0x101);
}

bool Library::isScheduled(unsigned long handle) const {
  return tasks_.count(handle) != 0;
}

void Library::startClock(std::unique_lock<std::mutex>& lock) {
  if (runs_) return;
  runs_ = true;
  std::thread before = std::move(clock_);
  lock.unlock();
  if (before.joinable()) before.join();
  lock.lock();
  clock_ = std::thread(&Library::run, this);
}

void Library::stopClock(std::unique_lock<std::mutex>& lock) {
  if (!runs_) return;
  runs_ = false;
  wake_.notify_all();
  std::thread before = std::move(clock_);
  lock.unlock();
  if (before.joinable()) before.join();  // a callback that is at work comes back first
  lock.lock();
}

std::vector<Library::Task> Library::tasks() const {
  std::vector<Task> all;
  for (const auto& [handle, task] : tasks_) all.push_back(task);
  std::stable_sort(all.begin(), all.end(), [](const Task& a, const Task& b) { return a.priority > b.priority; });
  return all;
}

void Library::run() {
  std::unique_lock<std::mutex> lock(mutex);
  auto deadline = std::chrono::steady_clock::now();
  while (runs_) {
    const std::int64_t period_ns = 1'000'000'000 / rate_hz_;
    // Deadlines that have passed are left out.
    deadline = std::max(deadline + std::chrono::nanoseconds(period_ns), std::chrono::steady_clock::now());
    wake_.wait_until(lock, deadline, [this] { return !runs_; });
    if (!runs_ || halted_) continue;
    arm_.f_T_W = motors_N_;
    arm_.advance(period_ns);
    for (const Task& task : tasks()) {
      if (!isScheduled(task.handle)) continue;
      lock.unlock();
      const bool goes_on = task.callback(task.self) == 1;
      lock.lock();
      if (!goes_on) tasks_.erase(task.handle);
    }
  }
}

}  // namespace underact::test::hd
