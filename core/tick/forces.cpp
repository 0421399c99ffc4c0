#include "core/tick/forces.h"

#include <cmath>

#include "core/arm/inverse.h"
#include "core/arm/statics.h"
#include "core/base/norms.h"
#include "core/tick/energy.h"
#include "core/tick/step.h"

namespace underact::tick {
namespace {

constexpr double kBumpOver_N = 1e-9;  // the remainder of a smoothed step that is dropped

/// The input that a tick gives to each of its constraints.
struct Around {
  const TickProgram& program;
  const control::LawInput& moment;
  TickReport& report;
};

/// The force of the torques that pull joints 1 to 3 towards the joint angles of the target.
/// Source: Beckman 2007, section 4.1 (its joint-space scheme), with errata section 2's inverse; tau = J_p^T f.
Vec3 forceByJoints(const Around& around, const Entry& entry, const Vec3& p_WP,
                   EntryState& state) noexcept UNDERACT_REAL_TIME {
  const arm::JointAngles& q_rad = around.report.sample.q_rad;
  if (!state.follower.begun) state.follower.q_rad = q_rad;
  const arm::Followed asked = arm::followPosition(around.program.geometry, state.follower, p_WP);
  state.follower = asked.next;
  const arm::JointAngles wanted_rad = arm::withinLimits(around.program.joint_limits, asked.next.q_rad);
  const Vec3 e_rad(wanted_rad[0] - q_rad[0], wanted_rad[1] - q_rad[1], wanted_rad[2] - q_rad[2]);
  const Vec3 torque_N_m = control::force(entry.law, state.law, e_rad, around.moment);
  const arm::ForceOfTorque pushed = arm::forceOf(around.program.geometry, q_rad, torque_N_m);
  around.report.branch_changes += asked.changed ? 1 : 0;
  around.report.out_of_reach |= !asked.reachable;
  around.report.damping_m = std::fmax(around.report.damping_m, pushed.damping_m);
  return pushed.f_T_W;
}

/// The force of the law.
Vec3 pushOf(const Around& around, const Entry& entry, const ConstraintReport& held,
            EntryState& state) noexcept UNDERACT_REAL_TIME {
  const Vec3 e_W = held.p_WP - around.report.p_WT;
  const Vec3 f_T_W = entry.space == Space::Joint ? forceByJoints(around, entry, held.p_WP, state)
                                                 : control::force(entry.law, state.law, e_W, around.moment);
  if (held.robot.joints > 0) return f_T_W + held.robot.f_along_T_W;
  const bool pulls = entry.constraint.side != target::Side::Both && f_T_W.dot(e_W) < 0.0;
  return pulls ? Vec3(Vec3::Zero()) : f_T_W;  // a wall never pulls
}

/// The force of one constraint; zero where it is free, degenerate or not chosen.
Vec3 forceOf(const Around& around, const Entry& entry, const ConstraintReport& held,
             EntryState& state) noexcept UNDERACT_REAL_TIME {
  if (held.status == target::Status::Unique && held.acts) return pushOf(around, entry, held, state);
  if (around.program.needs.joints) state.follower.begun = false;
  if (!around.program.needs.rate) return Vec3::Zero();
  if (held.status == target::Status::Free || held.acts) {
    control::rest(state.law, held.status == target::Status::Degenerate);
    if (around.moment.idle) state.law.integral_T_W.setZero();
  } else {
    control::reset(state.law);  // another one is nearer: an old integral would return as a jump
  }
  return Vec3::Zero();
}

}  // namespace

Vec3 sumForces(const TickProgram& program, const control::LawInput& moment, const Vec3& displacement_T_W,
               TickState& state, TickReport& report) noexcept {
  const Around around{program, moment, report};
  Vec3 sum_T_W = Vec3::Zero();
  for (std::size_t index = 0; index < report.held.size(); ++index) {
    ConstraintReport& held = report.held[index];
    held.f_T_W = forceOf(around, program.entries[index], held, state.entries[index]);
    if (program.needs.energy) observeEnergy(program, moment, displacement_T_W, index, state, report);
    sum_T_W += held.f_T_W;
  }
  return sum_T_W;
}

Vec3 sumMoments(const ConstraintReports& held) noexcept {
  Vec3 sum_T_W = Vec3::Zero();
  for (const ConstraintReport& one : held) {
    if (one.acts && one.status == target::Status::Unique && one.robot.joints > 0) sum_T_W += one.robot.moment_W;
  }
  return sum_T_W;
}

void smoothForce(const control::LawInput& moment, TickState& state, Vec3& f_T_W) noexcept {
  if (moment.idle) {
    state.bump_T_W.setZero();
  } else if (state.retuned) {
    state.bump_T_W = state.asked_T_W - f_T_W;
  } else if (state.bump_T_W != Vec3::Zero()) {
    state.bump_T_W *= kBumpless_s / (kBumpless_s + moment.dt_s);
    if (largestOf(state.bump_T_W) < kBumpOver_N) state.bump_T_W.setZero();
  }
  state.retuned = false;
  f_T_W += state.bump_T_W;
  state.asked_T_W = f_T_W;
}

}  // namespace underact::tick
