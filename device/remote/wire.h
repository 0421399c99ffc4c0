#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "device/remote/address.h"
#include "device/remote/keys.h"

namespace underact::device::remote {

using Bytes = std::vector<std::uint8_t>;

/// How a line stands.
enum class LineState : std::uint8_t {
  Connecting,
  Connected,     // both ends have shown their keys
  NotReachable,  // nobody listens there
  NotAllowed,    // the other end does not know this one's key
  NotTheOne,     // what answers has another key, or does not speak ZeroMQ
  Gone           // it was connected
};

/// A line to somebody who shares an arm: ZeroMQ with CURVE, which shows each end that the other has the secret key it
/// should have, and hides what is said. One thread at a time. Nobody waits: what the network does not take is lost, and
/// a line that broke is not mended.
class Wire {
 public:
  /// server_key: of whoever listens there. Problems: no line can even be begun.
  static Result<std::unique_ptr<Wire>> open(const Address& address, const std::string& server_key, const KeyPair& own);
  ~Wire();
  Wire(const Wire&) = delete;
  Wire& operator=(const Wire&) = delete;

  /// Until something came, the state has changed, bell (below 0: none) is readable, or time_ms are over.
  void wait(int bell, int time_ms);
  /// The next message; false: there is none.
  bool receive(Bytes& bytes);
  bool send(std::span<const std::uint8_t> bytes);
  LineState state();

 private:
  struct Impl;
  explicit Wire(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Where such lines end: lets in those whose key it was given, and no others.
class Hub {
 public:
  /// Problems: it cannot listen there.
  static Result<std::unique_ptr<Hub>> open(const Address& address, const KeyPair& own,
                                           std::vector<std::string> allowed);
  ~Hub();
  Hub(const Hub&) = delete;
  Hub& operator=(const Hub&) = delete;

  /// Where it listens, with the port that the system chose.
  Address address() const;
  /// As Wire::wait().
  void wait(int bell, int time_ms);
  /// The next message, and from whom; false: there is none.
  bool receive(std::string& from, Bytes& bytes);
  bool send(const std::string& to, std::span<const std::uint8_t> bytes);
  /// Those who were turned away for their key since the last call.
  int turnedAway();
  /// Those who have connected since the last call, whoever they are.
  int connections();
  /// Whether messages are carried as urgently as the system grants, or as any program's. Not, by itself: whoever can
  /// connect could else keep what is real-time here busy.
  void hurry(bool on);

 private:
  struct Impl;
  explicit Hub(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::device::remote
