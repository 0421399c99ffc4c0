#pragma once
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/serve/endpoint.h"

namespace underact::serve {

/// What the endpoint says of a connection.
struct Leave {
  bool is_known = false, may_be_read = true, closes = false;
  bool operator==(const Leave&) const = default;
};

/// A connection that has something for the endpoint: what came of it, and what is to go. All of it is guarded by the
/// mutex, which is held for moments only.
struct Line {
  std::mutex mutex;
  // From the sockets' thread.
  std::optional<HttpRequest> question = {};  // over plain HTTP: nothing else comes. None: it speaks WebSocket
  bool is_gone = false;                      // nothing more comes
  std::deque<Frame> frames = {};             // the first one stays, without its text, until it is received
  std::size_t frame_bytes = 0;
  // From the endpoint's.
  std::optional<HttpAnswer> answer = {};  // to the question
  std::deque<Message> messages = {};
  std::size_t message_bytes = 0;
  Leave leave = {};
};

/// The sockets of a server, on a thread of their own. It takes connections, reads frames and writes messages; stops the
/// servo where a frame says so, whatever the endpoint's thread does meanwhile; refuses what comes too fast; and ends
/// connections that do not say who they are in time.
class Sockets {
 public:
  /// came: called from that thread when the endpoint has something to do.
  explicit Sockets(std::function<void()> came);
  ~Sockets();
  Sockets(const Sockets&) = delete;
  Sockets& operator=(const Sockets&) = delete;
  /// One more port, before start(). Why it is not possible; empty: it is.
  std::string listen(int port, std::vector<std::string> origins);
  int port(std::size_t door) const;
  /// Takes connections from now on. endpoints: one for each port; only their functions for any thread are called.
  void start(const std::vector<Endpoint*>& endpoints);
  /// The lines of a port since the last call.
  std::vector<std::shared_ptr<Line>> takeNew(std::size_t door);
  /// Has that thread look at what was changed in the lines. Any thread.
  void look();
  /// Ends all connections, listens no more, and ends the thread.
  void stop();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::serve
