#pragma once
#include "core/base/real_time.h"
#include "core/tick/report.h"
#include "core/tick/state.h"

namespace underact::tick {

/// What comes into a tick from outside. Time comes in with the sample; no clock is read.
struct TickInput {
  arm::Sample sample;
  bool has_sample = true;  // false: the arm gave none in time
  bool engage = false;     // the servo is to push
  bool restart = false;    // Start was pressed in this tick: forget the last fault
  bool late = false;       // this tick started a whole period late
  Fault fault = {};        // what the servo found wrong before the tick; none: it is the sample that counts
  // The servo's own time, by which the gate goes: a period, and beside it the deadlines that passed without a tick. A
  // period of 0 says that whoever ticks keeps the sample's clock himself (a lab), or kept it (version 0.1.0).
  double period_s = 0.0;
  double waited_s = 0.0;
};

// Time constant of the way from the old gains' force to the new ones'. Three of them are 60 ms: felt as at once, but
// not as a knock.
inline constexpr double kBumpless_s = 0.02;

/// One tick: sample -> kinematics -> target -> law -> gate -> force. Everything it knows comes in by its arguments, all
/// it remembers is in state, all it found out is in report; equal arguments give equal results to the last bit. state:
/// from makeState(program). report.fault says why report.force is zero.
void step(const TickProgram& program, const TickInput& input, TickState& state,
          TickReport& report) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::tick
