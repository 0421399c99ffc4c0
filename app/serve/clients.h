#pragma once
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "app/serve/request.h"
#include "app/serve/rows.h"

namespace underact::serve {

inline constexpr std::size_t kMostMessages = 1000;           // answers and events that wait for a client
inline constexpr std::size_t kMostMessageBytes = 4U << 20U;  // the same, bytes
inline constexpr int kMostBadFrames = 3;

/// One end of a connection.
struct Client {
  int number = 0;
  std::string name;  // of hello
  bool is_known = false;
  bool closes = false;
  bool is_silent = false;  // it takes no messages
  int bad_frames = 0;
  double connected_s = 0.0;
  std::optional<Subscription> subscription = {};
  std::deque<Message> messages = {};  // answers and events
  std::size_t message_bytes = 0;
  std::deque<Request> held_back = {};  // until its load is done
  std::int64_t dropped_events = 0;

  /// An answer always finds room: a client that does not take its answers is not read.
  void send(std::string text) {
    if (is_silent) return;
    message_bytes += text.size();
    messages.push_back({std::move(text), false});
  }
  /// An event finds room, or is counted as dropped.
  void tell(const std::string& text) {
    if (messages.size() < kMostMessages && message_bytes < kMostMessageBytes)
      send(text);
    else
      ++dropped_events;
  }
};

}  // namespace underact::serve
