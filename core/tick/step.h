#pragma once
#include "core/base/real_time.h"
#include "core/tick/program.h"
#include "core/tick/report.h"

namespace underact::tick {

/// What comes into a tick from outside. Time comes in with the sample; no clock is read.
struct TickInput {
  arm::Sample sample;
  bool has_sample = true;  // false: the arm gave none in time
  bool engage = false;     // the servo is to push
  bool restart = false;    // Start was pressed in this tick: forget the last fault
};

/// One tick: sample -> kinematics -> target -> law -> gate -> force. Everything it knows comes in by its arguments, all
/// it remembers is in state, all it found out is in report; equal arguments give equal results to the last bit. state:
/// from makeState(program). report.fault says why report.force is zero.
void step(const TickProgram& program, const TickInput& input, TickState& state,
          TickReport& report) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::tick
