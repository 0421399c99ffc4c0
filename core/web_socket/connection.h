#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/web_socket/loop.h"

namespace underact::web_socket {

/// Called when something is done. false: it failed; the connection is of no more use.
using Then = std::function<void(bool is_done)>;

/// What the other side may send, and how long it may take.
struct Limits {
  std::uint32_t header_bytes = 8192;
  std::uint64_t body_bytes = 1U << 20U;
  std::size_t message_bytes = 1U << 24U;
  /// To connect and ask, and as long again for the handshake; none: without end. Only of who was accepted.
  std::optional<Milliseconds> patience = {};
  /// Of silence: after half of it the other side is sent a ping, after all of it the connection is taken for dead.
  std::optional<Milliseconds> silence = {};
};

/// A request over plain HTTP, or to go on as a WebSocket.
struct Request {
  std::string method;  // "GET"
  std::string target;  // "/devices?session=1"
  std::string body;
  std::string host;                   // whom it asks, as it names it: "localhost:7171"
  std::optional<std::string> origin;  // the page that asks
  bool is_upgrade = false;
};

inline constexpr std::uint16_t kNormalEnd = 1000, kPolicyError = 1008;

/// A connection of TCP that becomes a WebSocket, of whose messages each is one frame: simple clients read no others. No
/// call waits, but for a name's address in connect(). What is under way keeps the connection alive, so that `then` is
/// always called, unless the loop is gone; nothing else is called.
class Connection {
 public:
  struct Impl;  // Beast's stream, and what is under way
  /// Not connected yet. loop: outlives it.
  explicit Connection(EventLoop& loop);
  explicit Connection(std::shared_ptr<Impl> impl);  // for this room alone
  ~Connection();
  /// What was moved from can only be destroyed.
  Connection(Connection&&) noexcept;
  Connection& operator=(Connection&&) noexcept;  // likewise
  /// Before all else.
  void limit(const Limits& limits);

  // Who was accepted: what it asks, and the answer.
  /// Its request, but for the body.
  void readHeader(Then then);
  /// What was left out by readHeader().
  void readBody(Then then);
  /// What was read of it.
  Request request() const;
  /// Over plain HTTP. status: as in HTTP, 200; content_type: empty: not said.
  void respond(int status, const std::string& content_type, const std::string& body, Then then);
  /// The handshake, for a request that is_upgrade.
  void accept(Then then);

  // Who connects.
  void connect(const std::string& host, int port, Then then);
  /// host: as it was asked for, with the port.
  void handshake(const std::string& host, Then then);
  /// GET over plain HTTP. The body of the answer; none: there is none, or it was refused.
  void get(const std::string& host, const std::string& target, std::function<void(std::optional<std::string>)> then);

  // As a WebSocket.
  /// The next message. It lasts until the next read().
  void read(std::function<void(bool is_done, std::string_view message, bool is_text)> then);
  /// message: is not copied. After the one before is done.
  void write(std::string_view message, bool is_binary, Then then);
  /// Says goodbye, and waits for the answer.
  void close(std::uint16_t reason, Then then);
  /// Now, and without a word.
  void end();

 private:
  std::shared_ptr<Impl> impl_;
};

}  // namespace underact::web_socket
