#pragma once
#include "core/servo/snapshot.h"
#include "core/tick/state.h"

namespace underact::servo {

/// A tick program with its memory that is fed what went into ticks of a servo: of a recording, or of one that runs,
/// with another program. It reckons what that servo would; nobody feels it. One thread.
class Rerun {
 public:
  /// period_ns: of that servo; 0: one of version 0.1.0, whose gate went by the arm's clock.
  Rerun(tick::TickProgram program, tick::TickState state, std::int64_t period_ns);
  /// With no memory yet.
  Rerun(tick::TickProgram program, std::int64_t period_ns);

  /// The servo ticks at another rate.
  void setPeriod(std::int64_t period_ns) { period_ns_ = period_ns; }
  /// Goes on with another program; carry: how much of the memory it takes over. Allocates.
  void replaceBy(tick::TickProgram program, tick::Carry carry);
  /// recorded: what went in, and when it was. fault: what the servo had found before the tick. restart: as if Start
  /// had been pressed. The mode is left as it was: it is the servo's, not the tick's.
  const Snapshot& tick(const TickRecord& recorded, const Fault& fault, bool restart);
  const Snapshot& snapshot() const { return snapshot_; }
  const arm::Geometry& geometry() const { return program_.geometry; }

 private:
  tick::TickProgram program_;
  tick::TickState state_;
  std::int64_t period_ns_;
  Snapshot snapshot_;
};

}  // namespace underact::servo
