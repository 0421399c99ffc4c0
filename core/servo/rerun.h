#pragma once
#include "core/servo/snapshot.h"
#include "core/tick/program.h"

namespace underact::servo {

/// A tick program with its memory that is fed what went into ticks of a servo: of a recording, or of one that runs,
/// with another program. It reckons what that servo would; nobody feels it. One thread.
class Rerun {
 public:
  Rerun(tick::TickProgram program, tick::TickState state);
  /// With no memory yet.
  explicit Rerun(tick::TickProgram program);

  void replaceBy(tick::TickProgram program, tick::Carry carry);
  /// recorded: what went in, and when it was. fault: what the servo had found before the tick. restart: as if Start
  /// had been pressed. The mode is left as it was: it is the servo's, not the tick's.
  const Snapshot& tick(const TickRecord& recorded, const Fault& fault, bool restart);
  const Snapshot& snapshot() const { return snapshot_; }
  const arm::Geometry& geometry() const { return program_.geometry; }

 private:
  tick::TickProgram program_;
  tick::TickState state_;
  Snapshot snapshot_;
};

}  // namespace underact::servo
