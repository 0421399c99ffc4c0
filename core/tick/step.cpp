#include "core/tick/step.h"

#include <cmath>

#include "core/arm/forward.h"
#include "core/arm/inverse.h"
#include "core/arm/statics.h"
#include "core/base/units.h"

namespace underact::tick {
namespace {

/// A law is not let loose on a longer pause than this: after one, rate and integral start as on a first tick.
constexpr double kLongestTick_s = 0.1;

void forget(TickState& state) noexcept UNDERACT_REAL_TIME {
  for (control::LawState& law : state.laws) law = control::LawState{};
  for (target::InfluenceState& influence : state.influences) influence = target::InfluenceState{};
  for (manipulator::State& robot : state.robots) robot.begun = false;
  for (arm::FollowerState& follower : state.followers) follower.begun = false;
}

/// 0 at the first tick. The difference wraps instead of overflowing; what wraps is stale.
double secondsSince(const TickState& state, std::int64_t time_ns) noexcept UNDERACT_REAL_TIME {
  if (!state.has_time) return 0.0;
  const std::uint64_t passed_ns = static_cast<std::uint64_t>(time_ns) - static_cast<std::uint64_t>(state.time_ns);
  return kSecondPerNanosecond * static_cast<double>(static_cast<std::int64_t>(passed_ns));
}

Fault judge(const TickInput& input, const TickState& state, double dt_s) noexcept UNDERACT_REAL_TIME {
  if (!input.has_sample) return {FaultKind::NoSample, 0.0, 0.0};
  for (const double angle_rad : input.sample.q_rad) {
    if (!std::isfinite(angle_rad)) return {FaultKind::NotFinite, angle_rad, 0.0};
  }
  const double shin_rad = input.sample.q_rad[1] + input.sample.q_rad[2];  // two finite ones may overflow
  if (!std::isfinite(shin_rad)) return {FaultKind::NotFinite, shin_rad, 0.0};
  if (state.has_time && dt_s <= 0.0) return {FaultKind::StaleSample, dt_s, 0.0};
  return {};
}

/// Where the tip is; and where the stylus points, if any target asks.
void lookAtArm(const TickProgram& program, const arm::Sample& sample, TickState& state,
               TickReport& report) noexcept UNDERACT_REAL_TIME {
  if (!program.needs.orientation) {
    state.p_WT = arm::tipPosition(program.geometry, sample.q_rad);
    return;
  }
  const Pose X_WT = arm::tipPose(program.geometry, sample.q_rad);
  state.p_WT = X_WT.translation();
  report.R_WT = X_WT.linear();
  report.stylus_W = X_WT.linear().col(2);
}

/// The target of the constraint at index.
target::Target targetOf(const target::Constraint& constraint, std::size_t index, double dt_s, TickState& state,
                        TickReport& report) noexcept UNDERACT_REAL_TIME {
  if (constraint.manipulator) {
    Pose X_WT = Pose::Identity();
    X_WT.linear() = report.R_WT;
    X_WT.translation() = report.p_WT;
    return manipulatedTarget(constraint, X_WT, dt_s, state.robots[index], report.held[index].robot);
  }
  if (!constraint.influenced) return nearestTarget(constraint, report.p_WT);
  return influencedTarget(constraint, report.p_WT, report.stylus_W, dt_s, state.influences[index]);
}

void findTargets(const TickProgram& program, double dt_s, TickState& state,
                 TickReport& report) noexcept UNDERACT_REAL_TIME {
  for (std::size_t index = 0; index < report.held.size(); ++index) {
    Held& held = report.held[index];
    const target::Constraint& constraint = program.entries[index].constraint;
    // A robot is told anew in full; of another constraint, one of an earlier program may still stand here.
    if (!constraint.manipulator && held.robot.joints > 0) held.robot = target::Robot{};
    const target::Target target = targetOf(constraint, index, dt_s, state, report);
    const bool acts = target.status != target::Status::Free;
    held.p_WP = target.p_WP;
    held.f_T_W.setZero();
    held.status = target.status;
    held.distance_m = target.distance_m;
    held.acts = acts;
    held.angles = target.angles;
    held.arc = target.arc;
  }
}

/// Leaves `acts` only at the nearest of the constraints that are touched; the first of equals.
void keepNearest(HeldList& held) noexcept UNDERACT_REAL_TIME {
  std::size_t nearest = held.size();
  for (std::size_t index = 0; index < held.size(); ++index) {
    held[index].acts = false;
    if (held[index].status == target::Status::Free) continue;
    if (nearest == held.size() || held[index].distance_m < held[nearest].distance_m) nearest = index;
  }
  if (nearest < held.size()) held[nearest].acts = true;
}

/// What a tick hands down to each of its constraints.
struct Around {
  const TickProgram& program;
  const control::Moment& moment;
  TickReport& report;
};

/// The force of the torques that draw joints 1 to 3 to those that the target asks for.
/// Source: Beckman 2007, section 4.1 (its joint-space scheme), with errata section 2's inverse; tau = J_p^T f.
Vec3 forceByJoints(const Around& around, const Entry& entry, const Vec3& p_WP, control::LawState& law,
                   arm::FollowerState& follower) noexcept UNDERACT_REAL_TIME {
  const arm::JointAngles& q_rad = around.report.sample.q_rad;
  if (!follower.begun) follower.q_rad = q_rad;
  const arm::Followed asked = arm::followPosition(around.program.geometry, follower, p_WP);
  follower = asked.next;
  const arm::JointAngles wanted_rad = arm::withinLimits(around.program.joint_limits, asked.next.q_rad);
  const Vec3 e_rad(wanted_rad[0] - q_rad[0], wanted_rad[1] - q_rad[1], wanted_rad[2] - q_rad[2]);
  const arm::ForceOfTorque pushed =
      arm::forceOf(around.program.geometry, q_rad, control::force(entry.law, law, e_rad, around.moment));
  around.report.branch_changes += asked.changed ? 1 : 0;
  around.report.out_of_reach |= !asked.reachable;
  around.report.damping_m = std::fmax(around.report.damping_m, pushed.damping_m);
  return pushed.f_T_W;
}

/// What the law asks for; a wall never pulls.
Vec3 pushOf(const Around& around, const Entry& entry, const Held& held, control::LawState& law,
            arm::FollowerState& follower) noexcept UNDERACT_REAL_TIME {
  const Vec3 e_W = held.p_WP - around.report.p_WT;
  const Vec3 f_T_W = entry.space == Space::Joint ? forceByJoints(around, entry, held.p_WP, law, follower)
                                                 : control::force(entry.law, law, e_W, around.moment);
  if (held.robot.joints > 0) return f_T_W + held.robot.f_along_T_W;
  if (entry.constraint.side != target::Side::Both && f_T_W.dot(e_W) < 0.0) return Vec3::Zero();
  return f_T_W;
}

/// The force of one constraint; zero where it is free, degenerate or not chosen.
Vec3 forceOf(const Around& around, const Entry& entry, const Held& held, control::LawState& law,
             arm::FollowerState& follower) noexcept UNDERACT_REAL_TIME {
  if (held.status == target::Status::Unique && held.acts) return pushOf(around, entry, held, law, follower);
  follower.begun = false;
  if (held.status == target::Status::Free || held.acts) {
    control::rest(law, held.status == target::Status::Degenerate);
    if (around.moment.idle) law.integral_T_W.setZero();
  } else {
    law = control::LawState{};  // another is nearer: an old integral would come back as a jump
  }
  return Vec3::Zero();
}

Vec3 sumForces(const TickProgram& program, TickState& state, TickReport& report,
               const control::Moment& moment) noexcept UNDERACT_REAL_TIME {
  const Around around{program, moment, report};
  Vec3 sum_T_W = Vec3::Zero();
  for (std::size_t index = 0; index < report.held.size(); ++index) {
    control::LawState no_law;
    arm::FollowerState no_follower;
    control::LawState& law = index < state.laws.size() ? state.laws[index] : no_law;
    arm::FollowerState& follower = index < state.followers.size() ? state.followers[index] : no_follower;
    Held& held = report.held[index];
    held.f_T_W = forceOf(around, program.entries[index], held, law, follower);
    sum_T_W += held.f_T_W;
  }
  return sum_T_W;
}

}  // namespace

void step(const TickProgram& program, const TickInput& input, TickState& state, TickReport& report) noexcept {
  if (input.restart) {  // begins anew in all: an arm that was unplugged counts its time from 0 again
    state.has_time = false;
    forget(state);
  }
  const double dt_s = secondsSince(state, input.sample.time_ns);
  const Fault fault = judge(input, state, dt_s);
  report.sample = input.sample;
  report.held.resize(0);
  report.R_WT.setIdentity();
  report.stylus_W.setZero();
  report.f_T_W.setZero();
  report.branch_changes = 0;
  report.out_of_reach = false;
  report.damping_m = 0.0;
  double gate_dt_s = 0.0;
  if (fault.kind == FaultKind::None) {
    const double law_dt_s = dt_s <= kLongestTick_s ? dt_s : 0.0;
    if (dt_s > kLongestTick_s) forget(state);
    gate_dt_s = law_dt_s;
    lookAtArm(program, input.sample, state, report);
    report.p_WT = state.p_WT;  // the targets are found from it
    report.held.resize(program.entries.size());
    findTargets(program, law_dt_s, state, report);
    if (program.needs.choice) keepNearest(report.held);
    const bool stopped = state.gate.fault.kind != FaultKind::None && !input.restart;
    const bool idle = stopped || (!input.engage && state.gate.level == 0.0);
    report.f_T_W = sumForces(program, state, report, {law_dt_s, state.limited, idle});
    state.time_ns = input.sample.time_ns;
    state.has_time = true;
  }
  report.p_WT = state.p_WT;
  const safety::Gated gated =
      safety::gate(program.limits, state.gate, {report.f_T_W, input.engage, input.restart, fault}, gate_dt_s);
  state.gate = gated.next;
  state.limited = gated.cut_N > 0.0 || gated.next.level < 1.0;
  report.force = gated.force;
  report.level = gated.next.level;
  report.cut_N = gated.cut_N;
  report.fault = gated.fault;
}

}  // namespace underact::tick
