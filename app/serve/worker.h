#pragma once
#include <deque>
#include <functional>
#include <future>
#include <optional>
#include <utility>

namespace underact::serve {

struct Client;

/// Does one piece of work after another beside the service's thread, for clients by their numbers. Whose work has begun
/// is waited for by the destructor; work that has not is dropped.
class Worker {
 public:
  using Then = std::function<void(Client&)>;
  /// Its result is called by who takes it, where the client is still there.
  using Work = std::function<Then()>;

  void add(int client, Work work);
  /// Forgets what a client's work would come to, and does not begin it any more.
  void drop(int client);
  /// Whether work of a client waits, is under way, or was not taken yet.
  bool has(int client) const;
  bool isEmpty() const { return !its_client_ && waiting_.empty(); }
  /// What is done, and whose it was. Begins the next.
  std::optional<std::pair<int, Then>> take();

 private:
  void begin();

  std::deque<std::pair<int, Work>> waiting_;
  std::future<Then> under_way_;
  std::optional<int> its_client_;  // none: it was dropped
};

}  // namespace underact::serve
