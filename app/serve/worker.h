#pragma once
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace underact::serve {

/// A thread that does one piece of work after another, for clients by their numbers. Whose work has begun is waited for
/// by the destructor; work that has not is dropped.
class Worker {
 public:
  using Then = std::function<void()>;
  /// Its result is called by who takes it.
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
  /// How many threads it has: 1 once there was work.
  int threads() const { return thread_.joinable() ? 1 : 0; }

 private:
  struct Piece {
    int client;
    Work work;  // null: under way, or done
    Then then;
  };
  void run();

  mutable std::mutex mutex_;  // of:
  std::condition_variable wakes_;
  std::deque<Piece> pieces_;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace underact::serve
