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
    pieces_.push_back({client, std::move(work), nullptr});
  }
  if (!thread_.joinable()) thread_ = std::thread(&Worker::run, this);
  wakes_.notify_one();
}

void Worker::drop(int client) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::erase_if(pieces_, [=](const Piece& piece) { return piece.client == client; });
}

bool Worker::has(int client) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::any_of(pieces_.begin(), pieces_.end(), [=](const Piece& piece) { return piece.client == client; });
}

bool Worker::isEmpty() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return pieces_.empty();
}

std::optional<std::pair<int, Worker::Then>> Worker::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto done =
      std::find_if(pieces_.begin(), pieces_.end(), [](const Piece& piece) { return piece.then != nullptr; });
  if (done == pieces_.end()) return std::nullopt;
  std::pair<int, Then> taken{done->client, std::move(done->then)};
  pieces_.erase(done);
  return taken;
}

void Worker::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  const auto next = [this] {
    return std::find_if(pieces_.begin(), pieces_.end(), [](const Piece& piece) { return piece.work != nullptr; });
  };
  while (true) {
    wakes_.wait(lock, [&] { return ends_ || next() != pieces_.end(); });
    if (ends_) return;
    const auto piece = next();
    const int client = piece->client;
    Work work = std::exchange(piece->work, nullptr);
    lock.unlock();
    Then then = work();
    work = nullptr;  // what it holds may be large: not under the lock
    lock.lock();
    const auto its = std::find_if(pieces_.begin(), pieces_.end(), [=](const Piece& one) {
      return one.client == client && one.work == nullptr && one.then == nullptr;
    });
    if (its != pieces_.end()) {
      its->then = std::move(then);
      continue;
    }
    lock.unlock();
    then = nullptr;  // likewise
    lock.lock();
  }
}

}  // namespace underact::serve
