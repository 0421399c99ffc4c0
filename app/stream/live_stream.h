#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/servo/snapshot.h"

namespace underact::stream {

inline constexpr const char* kThisMachine = "127.0.0.1";
inline constexpr int kPort = 9870;             // the default port of PlotJuggler's UDP server
inline constexpr int kMostMessages_hz = 1000;  // with a faster servo, every second, third ... tick is sent

/// The destination of a stream.
struct Address {
  std::string host = kThisMachine;  // a number, as in 192.168.1.20 or ::1
  int port = kPort;
  bool isThisMachine() const;
};

/// "PORT", "HOST" or "HOST:PORT" (a host of IPv6 in brackets). Problems: it is none of these.
Result<Address> readAddress(const std::string& text);

/// Ticks as JSON over UDP, one message per tick, for PlotJuggler and other listeners: {"timestamp": s, "tick": n,
/// "q1_rad": ...} with the numbers of a CSV recording; values that are not finite are omitted. Never waits: what the
/// network does not accept at once is lost, and counted. Any one thread, not the servo's.
class LiveStream {
 public:
  /// Problems: the address is not available here.
  static Result<LiveStream> open(const Address& address, int rate_hz);
  ~LiveStream();
  LiveStream(LiveStream&&) noexcept;
  LiveStream& operator=(LiveStream&&) noexcept;

  void send(const servo::TickRecord& record);
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
