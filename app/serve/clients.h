#pragma once
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "app/serve/endpoint.h"
#include "app/serve/rows.h"

namespace underact::serve {

inline constexpr std::size_t kMaxMessages = 1000;           // answers and events that wait for a client
inline constexpr std::size_t kMaxMessageBytes = 4U << 20U;  // the same, bytes
inline constexpr int kMaxBadFrames = 3;
inline constexpr std::size_t kMaxHeldBack = 100;             // requests that wait until an earlier one is done
inline constexpr std::size_t kMaxHeldBackBytes = 4U << 20U;  // the same, bytes

/// One end of a connection.
struct Client {
  int number = 0;
  std::string name;  // of hello
  bool is_known = false;
  bool closes = false;
  bool is_silent = false;  // it takes no messages
  bool is_challenged = false;
  int bad_frames = 0;
  std::optional<Subscription> subscription = {};
  std::deque<Message> messages = {};  // answers and events
  std::size_t message_bytes = 0;
  std::deque<Frame> held_back = {};
  std::size_t held_back_bytes = 0;
  std::int64_t dropped_events = 0;

  /// An answer always finds room: a client that does not take its answers is not read.
  void send(std::string text) {
    if (is_silent) return;
    message_bytes += text.size();
    messages.push_back({std::move(text), false});
  }
  /// An event finds room, or is counted as dropped.
  void tell(const std::string& text) {
    if (messages.size() < kMaxMessages && message_bytes < kMaxMessageBytes)
      send(text);
    else
      ++dropped_events;
  }
};

}  // namespace underact::serve
