#include "core/servo/rerun.h"

#include <utility>

#include "core/base/denormals.h"
#include "core/base/units.h"
#include "core/tick/step.h"

namespace underact::servo {

Rerun::Rerun(tick::TickProgram program, tick::TickState state, std::int64_t period_ns)
    : program_(std::move(program)), state_(std::move(state)), period_ns_(period_ns) {}

Rerun::Rerun(tick::TickProgram program, std::int64_t period_ns)
    : program_(std::move(program)), state_(tick::makeState(program_)), period_ns_(period_ns) {}

void Rerun::replaceBy(tick::TickProgram program, tick::Carry carry, std::int64_t over_ticks) {
  tick::TickState state = tick::makeState(program);
  tick::carryOver(program_, state_, program, state, carry, over_ticks);
  program_ = std::move(program);
  state_ = std::move(state);
}

const Snapshot& Rerun::tick(const TickRecord& recorded, const Fault& fault, bool restart, const Vec3& push_T_W) {
  tick::TickInput input;
  input.sample.time_ns = recorded.time_ns;
  input.sample.q_rad = recorded.q_rad;
  input.sample.buttons = recorded.buttons;
  input.has_sample = (recorded.input & kHadSample) != 0;
  input.engage = (recorded.input & kEngaged) != 0;
  input.restart = restart || (recorded.input & kRestarted) != 0;
  input.late = (recorded.input & kLate) != 0;
  input.fault = fault;
  input.push_T_W = push_T_W;
  if (period_ns_ > 0) {  // as the loop does
    input.period_s = kSecondPerNanosecond * static_cast<double>(period_ns_);
    input.waited_s = waited_s(recorded.lateness_ns, period_ns_);
  }
  {
    const FlushDenormals flush;  // as the servo thread does
    tick::carryTargets(program_, state_);
    tick::step(program_, input, state_, snapshot_.report);
  }
  snapshot_.ticks = recorded.tick;
  snapshot_.revision = recorded.revision;
  snapshot_.input = recorded.input;
  snapshot_.lateness_ns = recorded.lateness_ns;
  snapshot_.tick_ns = recorded.tick_ns;
  return snapshot_;
}

}  // namespace underact::servo
