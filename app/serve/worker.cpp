#include "app/serve/worker.h"

#include <algorithm>
#include <chrono>

namespace underact::serve {

void Worker::add(int client, Work work) {
  waiting_.emplace_back(client, std::move(work));
  begin();
}

void Worker::drop(int client) {
  std::erase_if(waiting_, [=](const auto& piece) { return piece.first == client; });
  if (its_client_ == client) its_client_.reset();
}

bool Worker::has(int client) const {
  return its_client_ == client ||
         std::any_of(waiting_.begin(), waiting_.end(), [=](const auto& piece) { return piece.first == client; });
}

std::optional<std::pair<int, Worker::Then>> Worker::take() {
  // Deferred: the system gave it no thread, so it is done here.
  while (under_way_.valid() && under_way_.wait_for(std::chrono::seconds(0)) != std::future_status::timeout) {
    const std::optional<int> client = std::exchange(its_client_, std::nullopt);
    Then then = under_way_.get();
    begin();
    if (client) return std::pair{*client, std::move(then)};
  }
  return std::nullopt;
}

void Worker::begin() {
  if (under_way_.valid() || waiting_.empty()) return;
  its_client_ = waiting_.front().first;
  under_way_ =
      std::async(std::launch::async | std::launch::deferred, [work = std::move(waiting_.front().second)]() mutable {
        Then then = work();
        work = nullptr;  // what it holds may be large, so it is destroyed here
        return then;
      });
  waiting_.pop_front();
}

}  // namespace underact::serve
