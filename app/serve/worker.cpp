#include "app/serve/worker.h"

#include <algorithm>
#include <utility>

namespace underact::serve {

Worker::~Worker() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
  }
  wakes_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void Worker::add(int client, Work work) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_.emplace_back(client, std::move(work));
  }
  if (!thread_.joinable()) thread_ = std::thread(&Worker::run, this);
  wakes_.notify_one();
}

void Worker::drop(int client) {
  const auto is_its = [=](const auto& piece) { return piece.first == client; };
  const std::lock_guard<std::mutex> lock(mutex_);
  std::erase_if(waiting_, is_its);
  std::erase_if(done_, is_its);
  if (at_work_for_ == client) at_work_for_.reset();
}

bool Worker::has(int client) const {
  const auto is_its = [=](const auto& piece) { return piece.first == client; };
  const std::lock_guard<std::mutex> lock(mutex_);
  return at_work_for_ == client || std::any_of(waiting_.begin(), waiting_.end(), is_its) ||
         std::any_of(done_.begin(), done_.end(), is_its);
}

bool Worker::isEmpty() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return !at_work_for_ && waiting_.empty() && done_.empty();
}

std::optional<std::pair<int, Worker::Then>> Worker::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (done_.empty()) return std::nullopt;
  std::pair<int, Then> taken = std::move(done_.front());
  done_.pop_front();
  return taken;
}

void Worker::run() {
  Work work;
  Then then;  // what they hold may be large, so they are destroyed without the lock
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    wakes_.wait(lock, [this] { return ends_ || !waiting_.empty(); });
    if (ends_) return;
    at_work_for_ = waiting_.front().first;
    std::swap(work, waiting_.front().second);
    waiting_.pop_front();
    lock.unlock();
    then = work();
    work = nullptr;
    lock.lock();
    if (at_work_for_) done_.emplace_back(*at_work_for_, std::move(then));
    at_work_for_.reset();
  }
}

}  // namespace underact::serve
