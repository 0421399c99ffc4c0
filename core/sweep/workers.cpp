#include "core/sweep/workers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace underact::sweep {
namespace {

// Giving cells takes twice the interval at which a rank reads its messages, about 1 ms; this much work in store hides
// it.
constexpr double kInStore_s = 0.02;
constexpr double kMaxInStore = 256.0;  // cells a thread

}  // namespace

Workers::Workers(const Sweep& sweep, int threads) : sweep_(sweep) {
  for (int thread = 0; thread < std::max(threads, 1); ++thread) threads_.emplace_back([this] { work(); });
}

Workers::~Workers() {
  {
    const std::lock_guard lock(mutex_);
    open_.clear();
    ends_ = true;
  }
  given_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

std::size_t Workers::wants() const {
  const std::lock_guard lock(mutex_);
  double each = 1.0;
  if (ran_ > 0) {
    const double mean_s = std::max(spent_s_ / static_cast<double>(ran_), 1e-9);
    each += std::min(std::floor(kInStore_s / mean_s), kMaxInStore);
  }
  const std::size_t max = threads_.size() * static_cast<std::size_t>(each);
  const std::size_t has = open_.size() + running_;
  return max > has ? max - has : 0;
}

void Workers::give(std::span<const std::size_t> cells) {
  {
    const std::lock_guard lock(mutex_);
    open_.insert(open_.end(), cells.begin(), cells.end());
  }
  given_.notify_all();
}

void Workers::drop() {
  const std::lock_guard lock(mutex_);
  open_.clear();
}

std::size_t Workers::held() const {
  const std::lock_guard lock(mutex_);
  return open_.size() + running_ + finished_.size();
}

std::vector<Finished> Workers::take(std::chrono::microseconds wait) {
  std::unique_lock lock(mutex_);
  done_.wait_for(lock, wait, [this] { return !finished_.empty(); });
  return std::exchange(finished_, {});
}

void Workers::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    given_.wait(lock, [this] { return ends_ || !open_.empty(); });
    if (ends_) return;
    const std::size_t cell = open_.front();
    open_.pop_front();
    ++running_;
    lock.unlock();
    const auto begin = std::chrono::steady_clock::now();
    Finished finished{cell, rowOf(sweep_, cell)};
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    lock.lock();
    --running_;
    ++ran_;
    spent_s_ += took.count();
    finished_.push_back(std::move(finished));
    done_.notify_one();
  }
}

}  // namespace underact::sweep
