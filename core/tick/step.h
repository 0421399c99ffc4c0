#pragma once
#include "core/base/real_time.h"
#include "core/tick/report.h"
#include "core/tick/state.h"

namespace underact::tick {

/// The input of a tick. Time comes with the sample; no clock is read.
struct TickInput {
  arm::Sample sample;
  bool has_sample = true;        // false: the arm gave none in time
  bool engage = false;           // the servo is to push
  bool restart = false;          // Start was pressed before this tick: the last fault is cleared
  bool late = false;             // this tick started a whole period late
  Fault fault = {};              // a fault found by the servo before the tick; none: the sample decides
  Vec3 push_T_W = Vec3::Zero();  // a force that somebody else adds before the gate, N; finite
  // The servo's own time, which the gate uses: a period, and besides it the deadlines that passed without a tick. A
  // period of 0: the caller advances the sample's clock by itself (a lab), or did so (version 0.1.0).
  double period_s = 0.0;
  double waited_s = 0.0;
};

// The time constant with which the force changes over after a change of gains. Three of them are 60 ms: felt as
// immediate, but not as a jolt.
inline constexpr double kBumpless_s = 0.02;

/// One tick: sample -> kinematics -> target -> law -> gate -> force. Its input are the arguments alone, its memory is
/// state, its results are in report; equal arguments give bit-identical results. state: from makeState(program).
/// report.fault says why report.force is zero.
void step(const TickProgram& program, const TickInput& input, TickState& state,
          TickReport& report) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::tick
