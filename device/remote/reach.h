#pragma once
#include <cstdint>
#include <memory>

#include "device/remote/address.h"
#include "device/remote/keys.h"
#include "device/remote/message.h"
#include "device/remote/wire.h"

namespace underact::device::remote {

inline constexpr std::int64_t kMillisecond_ns = 1'000'000;

/// Where an arm is shared, and the keys to it.
struct Reach {
  Address address;
  std::string server_key;
  KeyPair own;
};

/// The keys to that address from a user's folder. Problems: the other end's key is not known.
Result<Reach> reachOf(const Address& address, const KeyFolder& folder);

/// A line that stands. Problems: nobody listens there; one of the two keys is not known.
Result<std::unique_ptr<Wire>> reached(const Reach& reach, int time_ms);

/// The answer to a hello. Problems: nothing comes in time; the arm is refused, and is_busy says whether because another
/// has it.
Result<Welcome> welcomed(Wire& wire, const Hello& hello, const Address& address, int time_ms, bool& is_busy);

/// What is shared there; opens nothing. Problems: as above.
Result<Welcome> askWhat(const Reach& reach, int time_ms);

/// What was said of the arm there; what its own side said stays as it came.
Sentence ofArmAt(const Address& address, const Sentence& words);

}  // namespace underact::device::remote
