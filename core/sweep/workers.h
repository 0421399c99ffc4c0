#pragma once
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <span>
#include <thread>
#include <vector>

#include "core/base/result.h"
#include "core/sweep/sweep.h"

namespace underact::sweep {

/// A cell that was run.
struct Finished {
  std::size_t cell = 0;
  Result<std::string> row;
};

/// Threads that run the cells they are given; one thread owns them and takes what they finish.
class Workers {
 public:
  /// sweep: it outlives this. threads: above 0.
  Workers(const Sweep& sweep, int threads);
  ~Workers();  // waits for running cells
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// How many more cells to give: one for each thread, and for short cells as many more as keep a thread from waiting
  /// for cells from another machine.
  std::size_t wants() const;
  /// Cells to run, after those that were given before. Does not wait.
  void give(std::span<const std::size_t> cells);
  /// Drops the cells that were not begun.
  void drop();
  /// The number of cells that were given and whose row was not taken.
  std::size_t held() const;
  /// The cells finished since the last call; where there is none yet, waits up to `wait` for one.
  std::vector<Finished> take(std::chrono::microseconds wait);

 private:
  void work();

  const Sweep& sweep_;
  mutable std::mutex mutex_;
  std::condition_variable given_, done_;
  std::deque<std::size_t> open_;
  std::size_t running_ = 0;
  std::vector<Finished> finished_;
  bool ends_ = false;
  double spent_s_ = 0.0;  // by all threads, in the cells that ran
  std::size_t ran_ = 0;
  std::vector<std::thread> threads_;
};

}  // namespace underact::sweep
