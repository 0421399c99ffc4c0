#include "core/tick/rest.h"

#include "core/arm/inverse.h"
#include "core/tick/step.h"

namespace underact::tick {

TickReport evaluateAtRest(const TickProgram& program, const Vec3& p_WT, const Mat3& R_WT) {
  TickProgram there = program;
  TickInput input;
  if (program.needs.joints) {
    input.sample.q_rad = arm::solvePosition(program.geometry, p_WT).q_rad;
  } else {
    // An arm of length 0 whose base is at the position of the tip: its tip is there to the last bit, also for positions
    // that the real arm cannot reach.
    there.geometry = {0.0, 0.0, p_WT};
    there.joint_limits = arm::kNoJointLimits;
    there.watched = arm::watchedJoints(there.geometry);
  }
  if (program.needs.orientation) input.sample.q_rad = arm::solveWrist(input.sample.q_rad, R_WT);
  TickState state = makeState(there);
  Pose X_WT = Pose::Identity();
  X_WT.linear() = R_WT;
  X_WT.translation() = p_WT;
  std::vector<int> steps(state.entries.size(), 0);
  for (std::size_t index = 0; index < state.entries.size(); ++index) {
    const auto* robot = std::get_if<manipulator::Manipulator>(&program.entries[index].constraint.goal);
    if (robot != nullptr) state.entries[index].target.memory = settledState(*robot, X_WT, steps[index]);
  }
  TickReport report;
  step(there, input, state, report);
  for (std::size_t index = 0; index < steps.size() && index < report.held.size(); ++index) {
    report.held[index].robot.steps += steps[index];
  }
  return report;
}

target::Status statusOf(const ConstraintReports& held) noexcept {
  target::Status status = target::Status::Free;
  for (const ConstraintReport& one : held) {
    if (one.acts && one.status == target::Status::Unique) return target::Status::Unique;
    if (one.status == target::Status::Degenerate) status = target::Status::Degenerate;
  }
  return status;
}

}  // namespace underact::tick
