#pragma once
#include <cstdint>

#include "core/servo/late.h"
#include "core/system/thread.h"

namespace underact::servo {

/// The deadlines of a thread that ticks, and the cause of a late tick. It reads no clock: times come in, ns of
/// monotonicNow_ns().
class Deadlines {
 public:
  /// now_ns, now: the moment from which deadlines and interruptions count; the first deadline is a period later.
  Deadlines(std::int64_t period_ns, std::int64_t now_ns, const system::Interruptions& now)
      : period_ns_(period_ns), next_ns_(now_ns + period_ns), counted_(now) {}

  /// When to wake: at the next deadline, or, where the last tick ended past it at now_ns, a moment later. That moment
  /// keeps a thread that never keeps up from taking a core for itself, and within rtkit's limit on real time without a
  /// rest.
  std::int64_t wakeAt_ns(std::int64_t now_ns) const noexcept;

  /// A tick begins: its latency, and the deadlines that have passed besides its own. They are left out, so that no
  /// burst of ticks follows. The cause is not known yet.
  Wake begin(std::int64_t now_ns) noexcept;

  /// Why the tick that just began is a whole period late. now: the counts of the system at this moment; they are
  /// compared with those at the last late tick, so a page fault in between is taken for the cause even if it was not.
  /// An overrun is certain and takes precedence.
  LateCause causeOf(const system::Interruptions& now) noexcept;

  /// The tick took busy_ns in all, waiting_ns of them for the arm.
  void end(std::int64_t busy_ns, std::int64_t waiting_ns) noexcept;

 private:
  std::int64_t period_ns_;
  std::int64_t next_ns_;
  system::Interruptions counted_;
  std::int64_t busy_ns_ = 0;
  std::int64_t waiting_ns_ = 0;
};

}  // namespace underact::servo
