#pragma once
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace underact::serve {

struct Client;

/// A thread that does one piece of work after another, for clients by their numbers. Whose work has begun is waited for
/// by the destructor; work that has not is dropped.
class Worker {
 public:
  using Then = std::function<void(Client&)>;
  /// Its result is called by who takes it, where the client is still there.
  using Work = std::function<Then()>;
  Worker() = default;
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void add(int client, Work work);
  /// Forgets what a client's work would come to, and does not begin it any more.
  void drop(int client);
  /// Whether work of a client waits, is under way, or was not taken yet.
  bool has(int client) const;
  bool isEmpty() const;
  /// The next that is done, and whose it was.
  std::optional<std::pair<int, Then>> take();

 private:
  void run();

  mutable std::mutex mutex_;  // of:
  std::condition_variable wakes_;
  std::deque<std::pair<int, Work>> waiting_;
  std::optional<int> at_work_for_;
  std::deque<std::pair<int, Then>> done_;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace underact::serve
