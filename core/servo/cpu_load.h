#pragma once
#include <atomic>
#include <thread>
#include <vector>

namespace underact::servo {

/// While an object of this class exists, each core has a thread that computes and moves memory without a pause, at
/// normal priority.
class CpuLoad {
 public:
  /// Starts the threads, one for each core; the destructor ends them and waits.
  CpuLoad();
  ~CpuLoad();
  CpuLoad(const CpuLoad&) = delete;
  CpuLoad& operator=(const CpuLoad&) = delete;
  /// How often the threads have gone through their memory. Any thread.
  long rounds() const { return rounds_.load(std::memory_order_relaxed); }

 private:
  void work(int core);

  std::atomic<bool> ends_{false};
  std::atomic<long> rounds_{0};
  std::vector<std::thread> threads_;
};

}  // namespace underact::servo
