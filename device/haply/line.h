#pragma once
#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "device/haply/address.h"

namespace underact::device::haply {

/// A connection to a WebSocket service: text frames in and out. One thread at a time; only wait() waits, for anything
/// to happen. What comes is kept, the newest of it, until receive() takes it.
class Line {
 public:
  /// Problems: nobody listens there, or what does speaks no WebSocket; in so much time, ms.
  static Result<std::unique_ptr<Line>> open(const Place& place, int time_ms);
  /// Waits a moment for what is being sent, and says goodbye.
  ~Line();
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  /// Until a frame has come, one was sent, the connection is gone, the descriptor `bell` is readable (below 0: none),
  /// or so much time is over.
  void wait(int bell, int time_ms);
  /// The oldest frame that was not taken. false: there is none.
  bool receive(std::string& text);
  /// false: the one before is still being sent, or the connection is gone; then this one is not.
  bool send(std::string text);
  bool isSending() const;
  bool isOpen() const;

 private:
  struct Impl;
  explicit Line(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// The body of the answer to GET target over plain HTTP; empty: none came in so much time, or it was refused.
std::string getOverHttp(const Place& place, const std::string& target, int time_ms);

}  // namespace underact::device::haply
