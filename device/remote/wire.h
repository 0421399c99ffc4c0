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

/// The state of a connection.
enum class LineState : std::uint8_t {
  Connecting,
  Connected,     // both ends have proved their keys
  NotReachable,  // nobody listens there
  NotAllowed,    // the other end does not know this end's key
  NotTheOne,     // the other end has another key, or does not speak ZeroMQ
  Gone           // it was connected
};

/// A connection to a shared arm: ZeroMQ with CURVE, which proves to each end that the other has the expected secret
/// key, and encrypts the messages. One thread at a time. Nobody waits: what the network does not accept is lost, and a
/// lost connection is not restored.
class Wire {
 public:
  /// server_key: of the arm's end. Problems: no connection can even be started.
  static Result<std::unique_ptr<Wire>> open(const Address& address, const std::string& server_key, const KeyPair& own);
  ~Wire();
  Wire(const Wire&) = delete;
  Wire& operator=(const Wire&) = delete;

  /// Until something arrives, the state has changed, bell (below 0: none) is readable, or time_ms have passed.
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

/// The end that accepts such connections: admits the keys it was given, and no others.
class Hub {
 public:
  /// Problems: it cannot listen there.
  static Result<std::unique_ptr<Hub>> open(const Address& address, const KeyPair& own,
                                           std::vector<std::string> allowed);
  ~Hub();
  Hub(const Hub&) = delete;
  Hub& operator=(const Hub&) = delete;

  /// The address it listens at, with the port that the system chose.
  Address address() const;
  /// As Wire::wait().
  void wait(int bell, int time_ms);
  /// The next message and its sender; false: there is none.
  bool receive(std::string& from, Bytes& bytes);
  bool send(const std::string& to, std::span<const std::uint8_t> bytes);
  /// Those refused for their key since the last call.
  int rejected();
  /// Those that have connected since the last call, admitted or not.
  int connections();
  /// Whether messages are handled with the priority that the system grants, or with the normal one. Normal by default:
  /// otherwise anybody who can connect could keep the real-time threads busy.
  void setUrgent(bool on);

 private:
  struct Impl;
  explicit Hub(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::device::remote
