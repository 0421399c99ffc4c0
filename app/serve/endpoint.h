#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "app/serve/rows.h"

namespace underact::serve {

inline constexpr std::size_t kMaxClients = 8;            // that have said hello
inline constexpr std::size_t kMaxUnknown = 32;           // that have not yet
inline constexpr std::size_t kLongestFrame = 1U << 20U;  // bytes
inline constexpr std::size_t kLongestAtOnce = 16384;     // of a frame that the endpoint's thread reads itself, bytes

/// A message of WebSocket, as it came.
struct Frame {
  std::string text;
  bool is_text = true;
  std::uint64_t stops = 0;   // how often the servo had been stopped when it came
  bool has_stopped = false;  // it is a stop, and was counted there
};

/// A request over plain HTTP.
struct HttpRequest {
  std::string method;  // "GET"
  std::string target;  // "/devices?session=1"
  std::string body;
};

struct HttpAnswer {
  int status = 200;
  std::string body;
  std::string type = "application/json";
};

/// What the sockets of a server belong to: messages in, messages out. One thread, but for what says otherwise; no call
/// waits.
class Endpoint {
 public:
  Endpoint() = default;
  virtual ~Endpoint() = default;
  Endpoint(const Endpoint&) = delete;
  Endpoint& operator=(const Endpoint&) = delete;

  // Connections of WebSocket, each with a number.
  virtual int connect() = 0;
  /// Without effect where it is gone already.
  virtual void disconnect(int connection) = 0;
  virtual void receive(int connection, Frame frame, double now_s) = 0;
  /// Whether it may send many frames, and longer than a few seconds: it has said who it is.
  virtual bool isKnown(int connection) const = 0;
  /// Whether a message waits to be sent to it.
  virtual bool hasMessage(int connection) const = 0;
  /// The next one. Only where there is one.
  virtual Message takeMessage(int connection) = 0;
  /// Whether its next frame is to be read: a client that does not read its answers is not read either.
  virtual bool mayBeRead(int connection) const = 0;
  /// Whether it is to be closed once all its messages were sent.
  virtual bool closes(int connection) const = 0;

  /// To be called each millisecond while isBusy(), otherwise 30 times a second. now_s: any clock that is not set.
  virtual void poll(double now_s) = 0;
  virtual bool isBusy() const = 0;
  /// The answer to a request over plain HTTP, of those who do not speak WebSocket alone.
  virtual HttpAnswer answer(const HttpRequest&) { return {426, "This is a WebSocket service.\n", ""}; }

  // Any thread: the sockets' own, while that of the endpoint may be busy. Bounded for any frame.
  /// As soon as a frame comes: ends the force if a known client's frame says so, and notes that in the frame.
  virtual void heed(Frame&, bool /*is_known*/) {}
  /// The answer to a frame that is one too many, instead of receive(); none: such frames have to wait.
  virtual std::optional<std::string> tooSoon(std::string_view) const { return {}; }
};

}  // namespace underact::serve
