#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/servo/snapshot.h"

namespace underact::stream {

inline constexpr const char* kThisMachine = "127.0.0.1";
inline constexpr int kPort = 9870;            // the default port of PlotJuggler's UDP server
inline constexpr int kMaxMessages_hz = 1000;  // with a faster servo, every second, third ... tick is sent

/// The destination of a stream.
struct Address {
  std::string host = kThisMachine;  // a number, as in 192.168.1.20 or ::1
  int port = kPort;
  bool isThisMachine() const;
};

/// "PORT", "HOST" or "HOST:PORT" (a host of IPv6 in brackets). Problems: it is none of these.
Result<Address> readAddress(const std::string& text);

inline constexpr int kLiveVersion = 1;  // of the messages

/// Ticks as JSON over UDP, one message per tick, for PlotJuggler and other listeners: {"timestamp": s, "tick": n,
/// "q1_rad": ..., "underact_live": 1, "session": id, "clock": "arm", "unix_s": s} with the numbers of a CSV recording;
/// values that are not finite are omitted. Does not wait unless pace() was called: what the network does not accept at
/// once is lost, and counted. Any one thread, not the servo's. The guide's page: live_data.md.
class LiveStream {
 public:
  /// Problems: the address is not available here.
  static Result<LiveStream> open(const Address& address, int rate_hz);
  ~LiveStream();
  LiveStream(LiveStream&&) noexcept;
  LiveStream& operator=(LiveStream&&) noexcept;

  void send(const servo::TickRecord& record);
  /// The session that the messages belong to from now on, as in its file; empty: none.
  void setSession(const std::string& session_id);
  /// For ticks that come faster than real time: from now on send() waits where a receiver could not keep up, so that
  /// there are some 10,000 messages a second.
  void pace();
  /// Sets the rate of the servo from now on.
  void setRate(int rate_hz);
  std::int64_t sent() const;
  std::int64_t lost() const;

 private:
  struct Impl;
  explicit LiveStream(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::stream
