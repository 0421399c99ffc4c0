#include "device/remote/endpoint.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/translate.h"
#include "core/system/clock.h"

namespace underact::device::remote {
namespace {

Problems problem(Sentence sentence) {
  return {{std::move(sentence), {}}};
}

Problems refusalReason(LineState state, const Address& address) {
  const std::string where = address.text();
  switch (state) {
    case LineState::NotAllowed:
      return problem(phrase(TRANSLATE_NOOP("problem",
                                           "The arm at %1 is not shared with you: your key is not known there. Here, "
                                           "\"underact-cli share-arm --show-key\" prints the line to run there."),
                            {where}));
    case LineState::NotTheOne:
    case LineState::Gone:
      return problem(phrase(
          TRANSLATE_NOOP(
              "problem",
              "What answers at %1 is not the arm whose key is known here. If it was given a new key, run the line "
              "that \"underact-cli share-arm\" prints there; if not, somebody else is answering in its place."),
          {where}));
    default:
      return problem(phrase(TRANSLATE_NOOP("problem",
                                           "No arm is shared at %1. Is that computer on, does \"underact-cli "
                                           "share-arm\" run there, and is it listening for others (--listen)?"),
                            {where}));
  }
}

/// The next message; none: nothing arrived in time, or nothing known.
std::optional<Message> nextOf(Wire& wire, int time_ms) {
  const std::int64_t end_ns = system::monotonicNow_ns() + time_ms * kMillisecond_ns;
  for (Bytes bytes; system::monotonicNow_ns() < end_ns && wire.state() == LineState::Connected; wire.wait(-1, 1)) {
    while (wire.receive(bytes)) {
      std::optional<Message> message = readMessage(bytes);
      if (message) return message;
      if (const std::optional<int> version = versionOf(bytes); version && *version != kVersion)
        return Words{About::Refusal,
                     phrase(TRANSLATE_NOOP("problem",
                                           "It is shared with version %1 of the protocol, and this program speaks %2. "
                                           "Install the same release of Underact at both ends."),
                            {std::to_string(*version), std::to_string(kVersion)})};
    }
  }
  return {};
}

}  // namespace

Sentence ofArmAt(const Address& address, const Sentence& words) {
  return phrase(TRANSLATE_NOOP("problem", "The arm at %1: %2"), {address.text(), words});
}

Result<std::unique_ptr<Wire>> connectTo(const Endpoint& endpoint, int time_ms) {
  Result<std::unique_ptr<Wire>> wire = Wire::open(endpoint.address, endpoint.server_key, endpoint.own);
  if (!wire) return wire.problems();
  const std::int64_t end_ns = system::monotonicNow_ns() + time_ms * kMillisecond_ns;
  while (wire.value()->state() == LineState::Connecting && system::monotonicNow_ns() < end_ns)
    wire.value()->wait(-1, 1);
  const LineState state = wire.value()->state();
  if (state != LineState::Connected) return refusalReason(state, endpoint.address);
  return wire;
}

Result<Welcome> awaitWelcome(Wire& wire, const Hello& hello, const Address& address, int time_ms, bool& is_busy) {
  wire.send(bytesOf(hello));
  const std::int64_t end_ns = system::monotonicNow_ns() + time_ms * kMillisecond_ns;
  while (system::monotonicNow_ns() < end_ns) {
    const auto left_ms = static_cast<int>((end_ns - system::monotonicNow_ns()) / kMillisecond_ns);
    const std::optional<Message> message = nextOf(wire, std::max(left_ms, 1));
    if (!message) break;
    if (const Welcome* const welcome = std::get_if<Welcome>(&*message)) return *welcome;
    if (const Words* const words = std::get_if<Words>(&*message); words != nullptr && words->about != About::Trouble) {
      is_busy = words->about == About::InUse;
      return problem(ofArmAt(address, words->text));
    }
  }
  return problem(phrase(
      TRANSLATE_NOOP(
          "problem",
          "The arm at %1 does not answer, although its computer does. Restart \"underact-cli share-arm\" there."),
      {address.text()}));
}

Result<Endpoint> endpointOf(const Address& address, const KeyFolder& folder) {
  Result<KeyPair> own = folder.own();
  if (!own) return own.problems();
  Result<std::string> key = folder.keyOf(address);
  if (!key) return key.problems();
  if (key.value().empty())
    return problem(phrase(TRANSLATE_NOOP("problem",
                                         "The key of the arm at %1 is not known here. \"underact-cli share-arm\" "
                                         "prints, at the arm's computer, the line to run here once."),
                          {address.text()}));
  return Endpoint{address, key.value(), own.value()};
}

Result<Welcome> queryArm(const Endpoint& endpoint, int time_ms) {
  Result<std::unique_ptr<Wire>> wire = connectTo(endpoint, time_ms);
  if (!wire) return wire.problems();
  bool is_busy = false;
  return awaitWelcome(*wire.value(), {0, 1, true, {}}, endpoint.address, time_ms, is_busy);
}

}  // namespace underact::device::remote
