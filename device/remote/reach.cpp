#include "device/remote/reach.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/servo/clock.h"

namespace underact::device::remote {
namespace {

Problems problem(std::string sentence) {
  return {{std::move(sentence), {}}};
}

Problems whyNot(LineState state, const Address& address) {
  const std::string where = address.text();
  switch (state) {
    case LineState::NotAllowed:
      return problem(
          armAt(address) +
          " is not shared with you: your key is not known there. Here, \"underact-cli share-arm --show-key\" "
          "prints the line to run there.");
    case LineState::NotTheOne:
    case LineState::Gone:
      return problem("What answers at " + where +
                     " is not the arm whose key is known here. If it was given a new key, run the line that "
                     "\"underact-cli share-arm\" prints there; if it was not, somebody else answers in its place.");
    default:
      return problem("No arm is shared at " + where +
                     ". Is that computer on, does \"underact-cli share-arm\" run there, and is it listening for others "
                     "(--listen)?");
  }
}

/// What comes next; none: nothing came in time, or nothing that is known.
std::optional<Message> nextOf(Wire& wire, int time_ms) {
  const std::int64_t end_ns = servo::monotonicNow_ns() + time_ms * kMillisecond_ns;
  for (Bytes bytes; servo::monotonicNow_ns() < end_ns && wire.state() == LineState::Connected; wire.wait(-1, 1)) {
    while (wire.receive(bytes)) {
      std::optional<Message> message = readMessage(bytes);
      if (message) return message;
      if (const std::optional<int> version = versionOf(bytes); version && *version != kVersion)
        return Words{About::Refusal, "It is shared with version " + std::to_string(*version) +
                                         " of the protocol, and this program speaks " + std::to_string(kVersion) +
                                         ". Install the same release of Underact at both ends."};
    }
  }
  return {};
}

}  // namespace

std::string armAt(const Address& address) {
  return "The arm at " + address.text();
}

Result<std::unique_ptr<Wire>> reached(const Reach& reach, int time_ms) {
  Result<std::unique_ptr<Wire>> wire = Wire::open(reach.address, reach.server_key, reach.own);
  if (!wire) return wire.problems();
  const std::int64_t end_ns = servo::monotonicNow_ns() + time_ms * kMillisecond_ns;
  while (wire.value()->state() == LineState::Connecting && servo::monotonicNow_ns() < end_ns) wire.value()->wait(-1, 1);
  const LineState state = wire.value()->state();
  if (state != LineState::Connected) return whyNot(state, reach.address);
  return wire;
}

Result<Welcome> welcomed(Wire& wire, const Hello& hello, const Address& address, int time_ms, bool& is_busy) {
  wire.send(bytesOf(hello));
  const std::int64_t end_ns = servo::monotonicNow_ns() + time_ms * kMillisecond_ns;
  while (servo::monotonicNow_ns() < end_ns) {
    const auto left_ms = static_cast<int>((end_ns - servo::monotonicNow_ns()) / kMillisecond_ns);
    const std::optional<Message> message = nextOf(wire, std::max(left_ms, 1));
    if (!message) break;
    if (const Welcome* const welcome = std::get_if<Welcome>(&*message)) return *welcome;
    if (const Words* const words = std::get_if<Words>(&*message); words != nullptr && words->about != About::Trouble) {
      is_busy = words->about == About::InUse;
      return problem(armAt(address) + ": " + words->text);
    }
  }
  return problem(armAt(address) +
                 " does not answer, although its computer does. Start \"underact-cli share-arm\" anew there.");
}

Result<Reach> reachOf(const Address& address, const KeyFolder& folder) {
  Result<KeyPair> own = folder.own();
  if (!own) return own.problems();
  Result<std::string> key = folder.keyOf(address);
  if (!key) return key.problems();
  if (key.value().empty())
    return problem("The key of the arm at " + address.text() +
                   " is not known here. \"underact-cli share-arm\" prints, at the arm's computer, the line to run here "
                   "once.");
  return Reach{address, key.value(), own.value()};
}

Result<Welcome> askWhat(const Reach& reach, int time_ms) {
  Result<std::unique_ptr<Wire>> wire = reached(reach, time_ms);
  if (!wire) return wire.problems();
  bool is_busy = false;
  return welcomed(*wire.value(), {0, 1, true, {}}, reach.address, time_ms, is_busy);
}

}  // namespace underact::device::remote
