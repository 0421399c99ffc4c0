#pragma once
#include <cstdint>
#include <memory>

#include "device/remote/address.h"
#include "device/remote/keys.h"
#include "device/remote/message.h"
#include "device/remote/wire.h"

namespace underact::device::remote {

inline constexpr std::int64_t kMillisecond_ns = 1'000'000;

/// The address of a shared arm, and the keys to it.
struct Endpoint {
  Address address;
  std::string server_key;
  KeyPair own;
};

/// The keys to that address from a user's folder. Problems: the key of the arm is not known.
Result<Endpoint> endpointOf(const Address& address, const KeyFolder& folder);

/// An established connection. Problems: nobody listens there; one of the two keys is not known.
Result<std::unique_ptr<Wire>> connectTo(const Endpoint& endpoint, int time_ms);

/// The answer to a hello. Problems: none in time; the arm is refused, and is_busy says whether because another program
/// has it.
Result<Welcome> awaitWelcome(Wire& wire, const Hello& hello, const Address& address, int time_ms, bool& is_busy);

/// What is shared there; opens nothing. Problems: as above.
Result<Welcome> queryArm(const Endpoint& endpoint, int time_ms);

/// A problem at that arm; a message from the arm's own side stays as it came.
Sentence ofArmAt(const Address& address, const Sentence& words);

}  // namespace underact::device::remote
