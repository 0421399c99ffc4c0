#pragma once
#include "core/servo/snapshot.h"
#include "core/tick/state.h"

namespace underact::servo {

/// Runs a tick program on the recorded input of a servo's ticks: of a recording, or of a running servo with another
/// program. It computes what that servo would do, without a device. One thread.
class Rerun {
 public:
  /// period_ns: of that servo; 0: one of version 0.1.0, whose gate used the arm's clock.
  Rerun(tick::TickProgram program, tick::TickState state, std::int64_t period_ns);
  /// With a fresh state.
  Rerun(tick::TickProgram program, std::int64_t period_ns);

  /// The servo ticks with another period from now on.
  void setPeriod(std::int64_t period_ns) { period_ns_ = period_ns; }
  /// Goes on with another program; carry: how much of the memory it takes over; over_ticks: as in Change. Allocates.
  void replaceBy(tick::TickProgram program, tick::Carry carry, std::int64_t over_ticks = 0);
  /// Runs a tick. recorded: its input, and when it was. fault: what the servo had found before the tick. restart: as if
  /// Start had been pressed. push_T_W: the force that somebody added, N. The mode stays: it is the servo's, not the
  /// tick's.
  const Snapshot& tick(const TickRecord& recorded, const Fault& fault, bool restart,
                       const Vec3& push_T_W = Vec3::Zero());
  const Snapshot& snapshot() const { return snapshot_; }
  const arm::Geometry& geometry() const { return program_.geometry; }

 private:
  tick::TickProgram program_;
  tick::TickState state_;
  std::int64_t period_ns_;
  Snapshot snapshot_;
};

}  // namespace underact::servo
