#include "core/tick/step.h"

#include <cmath>

#include "core/arm/forward.h"
#include "core/arm/inverse.h"
#include "core/arm/jacobian.h"
#include "core/arm/statics.h"
#include "core/base/norms.h"
#include "core/base/units.h"
#include "core/tick/energy.h"

namespace underact::tick {
namespace {

/// A law is not let loose on a longer pause than this: after one, rate and integral start as on a first tick.
constexpr double kLongestTick_s = 0.1;
constexpr double kBumpOver_N = 1e-9;  // what is left of a smoothed step when it is forgotten

void forget(TickState& state) noexcept UNDERACT_REAL_TIME {
  for (control::LawState& law : state.laws) control::forget(law);
  for (control::EnergyState& energy : state.energies) energy = control::EnergyState{};
  for (target::InfluenceState& influence : state.influences) influence = target::InfluenceState{};
  for (manipulator::State& robot : state.robots) robot = manipulator::State{};
  for (arm::FollowerState& follower : state.followers) follower.begun = false;
  for (target::MeshState& mesh : state.meshes) mesh = target::MeshState{};
  for (target::CurveState& curve : state.curves) curve = target::CurveState{};
  for (target::Grip& grip : state.grips) grip.holds = false;
  state.bump_T_W.setZero();
  state.retuned = false;
}

/// 0 at the first tick. The difference wraps instead of overflowing; what wraps is stale.
double secondsSince(const TickState& state, std::int64_t time_ns) noexcept UNDERACT_REAL_TIME {
  if (!state.has_time) return 0.0;
  const std::uint64_t passed_ns = static_cast<std::uint64_t>(time_ns) - static_cast<std::uint64_t>(state.time_ns);
  return kSecondPerNanosecond * static_cast<double>(static_cast<std::int64_t>(passed_ns));
}

Fault judge(const TickInput& input, const TickState& state, double dt_s) noexcept UNDERACT_REAL_TIME {
  if (input.fault.kind != FaultKind::None) return input.fault;
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
void lookAtArm(const TickProgram& program, const arm::Sample& sample, TickReport& report,
               safety::Motion& motion) noexcept UNDERACT_REAL_TIME {
  if (!program.needs.orientation) {
    if (!program.needs.motors) {
      report.p_WT = arm::tipPosition(program.geometry, sample.q_rad);
      return;
    }
    const arm::Tip tip = arm::tip(program.geometry, sample.q_rad);
    report.p_WT = tip.p_WT;
    motion.J_p = tip.J_p;
    return;
  }
  const Pose X_WT = arm::tipPose(program.geometry, sample.q_rad);
  report.p_WT = X_WT.translation();
  report.R_WT = X_WT.linear();
  report.stylus_W = X_WT.linear().col(2);
  if (program.needs.motors) motion.J_p = arm::positionJacobian(program.geometry, sample.q_rad);
}

/// What the gate goes by. before: the state at the tick's beginning, with the last sample that counted.
struct GateTime {
  double dt_s = 0.0;
  double waited_s = 0.0;
  double way_s = 0.0;  // in which the tip went its way since that sample
};

/// Ramps, slew, heat and frozen time go by the servo's periods, so that a sample's clock cannot hold a force. Nothing
/// is pushed at the first sample, which says of no motion. by_arm_s: since the last sample by the arm's clock; what
/// the laws go by is law_dt_s.
GateTime gateTimeOf(const TickInput& input, const TickState& before, double by_arm_s,
                    double law_dt_s) noexcept UNDERACT_REAL_TIME {
  if (!(input.period_s > 0.0)) return {law_dt_s, 0.0, law_dt_s};  // as in version 0.1.0: by the sample's clock
  if (!before.has_time) return {};
  const double since_s = (before.gate.missed + 1) * input.period_s + input.waited_s;
  return {input.period_s, input.waited_s, safety::wayTime_s(by_arm_s, since_s)};
}

/// How the arm moved since the last sample, and how far its driven joints are from their stops. dt_s: 0 where there is
/// no last sample to compare with.
void lookAtMotion(const TickProgram& program, const arm::Sample& sample, const TickState& state, double dt_s,
                  const Vec3& p_WT, safety::Motion& motion) noexcept UNDERACT_REAL_TIME {
  if (dt_s > 0.0) motion.v_WT = (p_WT - state.p_WT) / dt_s;
  motion.moved = !(dt_s > 0.0) || sample.q_rad != state.q_rad;
  for (std::size_t joint = 0; joint < 3; ++joint) {
    const auto axis = static_cast<Eigen::Index>(joint);
    motion.room_below_rad[axis] = sample.q_rad[joint] - program.joint_limits.min_rad[joint];
    motion.room_above_rad[axis] = program.joint_limits.max_rad[joint] - sample.q_rad[joint];
  }
}

/// Takes the step out of a change of gains or targets: what the force would have jumped by is kept beside it and fades.
void smoothOver(double dt_s, bool idle, TickState& state, Vec3& f_T_W) noexcept UNDERACT_REAL_TIME {
  if (idle) {
    state.bump_T_W.setZero();
  } else if (state.retuned) {
    state.bump_T_W = state.asked_T_W - f_T_W;
  } else if (state.bump_T_W != Vec3::Zero()) {
    state.bump_T_W *= kBumpless_s / (kBumpless_s + dt_s);
    if (largestOf(state.bump_T_W) < kBumpOver_N) state.bump_T_W.setZero();
  }
  state.retuned = false;
  f_T_W += state.bump_T_W;
  state.asked_T_W = f_T_W;
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
  if (constraint.mesh) return meshTarget(*constraint.mesh, constraint.side, report.p_WT, state.meshes[index]);
  if (constraint.curve) return curveTarget(*constraint.curve, report.p_WT, dt_s, state.curves[index]);
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
    target::Target target = targetOf(constraint, index, dt_s, state, report);
    const bool leans = constraint.mesh && target.status == target::Status::Unique;
    const Vec3 lean_W =
        leans ? leanOfMesh(*constraint.mesh, state.meshes[index], report.p_WT, target.p_WP) : Vec3(Vec3::Zero());
    if (constraint.friction.isThere()) {
      const target::Whereabouts where{constraint.mesh ? &state.meshes[index] : nullptr,
                                      constraint.curve ? &state.curves[index] : nullptr};
      target = rubbedTarget(constraint, report.p_WT, target, where, state.grips[index]);
    }
    target.p_WP += lean_W;
    const bool acts = target.status != target::Status::Free;
    held.p_WP = target.p_WP;
    held.f_T_W.setZero();
    held.status = target.status;
    held.distance_m = target.distance_m;
    held.acts = acts;
    held.energy_J = 0.0;
    held.f_passive_T_W.setZero();
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

/// law: null where none remembers anything; then each is P.
Vec3 forceOfLaw(const Around& around, const Entry& entry, const Vec3& e,
                control::LawState* law) noexcept UNDERACT_REAL_TIME {
  if (law != nullptr) return control::force(entry.law, *law, e, around.moment);
  const control::P* const p = std::get_if<control::P>(&entry.law);
  return p != nullptr ? control::force(*p, e) : Vec3(Vec3::Zero());
}

/// The force of the torques that draw joints 1 to 3 to those that the target asks for.
/// Source: Beckman 2007, section 4.1 (its joint-space scheme), with errata section 2's inverse; tau = J_p^T f.
Vec3 forceByJoints(const Around& around, const Entry& entry, const Vec3& p_WP, control::LawState* law,
                   arm::FollowerState& follower) noexcept UNDERACT_REAL_TIME {
  const arm::JointAngles& q_rad = around.report.sample.q_rad;
  if (!follower.begun) follower.q_rad = q_rad;
  const arm::Followed asked = arm::followPosition(around.program.geometry, follower, p_WP);
  follower = asked.next;
  const arm::JointAngles wanted_rad = arm::withinLimits(around.program.joint_limits, asked.next.q_rad);
  const Vec3 e_rad(wanted_rad[0] - q_rad[0], wanted_rad[1] - q_rad[1], wanted_rad[2] - q_rad[2]);
  const arm::ForceOfTorque pushed = arm::forceOf(around.program.geometry, q_rad, forceOfLaw(around, entry, e_rad, law));
  around.report.branch_changes += asked.changed ? 1 : 0;
  around.report.out_of_reach |= !asked.reachable;
  around.report.damping_m = std::fmax(around.report.damping_m, pushed.damping_m);
  return pushed.f_T_W;
}

/// A wall never pulls.
Vec3 pushOnly(const Entry& entry, const Held& held, const Vec3& e_W, const Vec3& f_T_W) noexcept UNDERACT_REAL_TIME {
  const bool is_wall = entry.constraint.side != target::Side::Both && held.robot.joints == 0;
  return is_wall && f_T_W.dot(e_W) < 0.0 ? Vec3(Vec3::Zero()) : f_T_W;
}

/// What the law asks for.
Vec3 pushOf(const Around& around, const Entry& entry, const Held& held, control::LawState* law,
            arm::FollowerState& follower) noexcept UNDERACT_REAL_TIME {
  const Vec3 e_W = held.p_WP - around.report.p_WT;
  const Vec3 f_T_W = entry.space == Space::Joint ? forceByJoints(around, entry, held.p_WP, law, follower)
                                                 : forceOfLaw(around, entry, e_W, law);
  if (held.robot.joints > 0) return f_T_W + held.robot.f_along_T_W;
  return pushOnly(entry, held, e_W, f_T_W);
}

/// The force of one constraint; zero where it is free, degenerate or not chosen.
Vec3 forceOf(const Around& around, const Entry& entry, const Held& held, control::LawState* law,
             arm::FollowerState& follower) noexcept UNDERACT_REAL_TIME {
  if (held.status == target::Status::Unique && held.acts) return pushOf(around, entry, held, law, follower);
  follower.begun = false;
  if (law == nullptr) return Vec3::Zero();
  if (held.status == target::Status::Free || held.acts) {
    control::rest(*law, held.status == target::Status::Degenerate);
    if (around.moment.idle) law->integral_T_W.setZero();
  } else {
    control::forget(*law);  // another is nearer: an old integral would come back as a jump
  }
  return Vec3::Zero();
}

/// way_T_W: of the tip since the last tick.
Vec3 sumForces(const TickProgram& program, const Vec3& way_T_W, TickState& state, TickReport& report,
               const control::Moment& moment) noexcept UNDERACT_REAL_TIME {
  const Around around{program, moment, report};
  Vec3 sum_T_W = Vec3::Zero();
  for (std::size_t index = 0; index < report.held.size(); ++index) {
    arm::FollowerState no_follower;
    control::LawState* const law = index < state.laws.size() ? &state.laws[index] : nullptr;
    arm::FollowerState& follower = index < state.followers.size() ? state.followers[index] : no_follower;
    Held& held = report.held[index];
    held.f_T_W = forceOf(around, program.entries[index], held, law, follower);
    if (program.needs.energy) watchEnergy(program, moment, way_T_W, index, state, report);
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
  const bool is_good = fault.kind == FaultKind::None;
  const double law_dt_s = is_good && dt_s <= kLongestTick_s ? dt_s : 0.0;
  const GateTime time = gateTimeOf(input, state, dt_s, law_dt_s);
  safety::Motion motion;
  if (is_good) {
    if (dt_s > kLongestTick_s) forget(state);
    lookAtArm(program, input.sample, report, motion);  // the targets are found from it
    lookAtMotion(program, input.sample, state, time.way_s, report.p_WT, motion);
    const Vec3 way_T_W = law_dt_s > 0.0 ? Vec3(report.p_WT - state.p_WT) : Vec3(Vec3::Zero());
    state.p_WT = report.p_WT;
    state.q_rad = input.sample.q_rad;
    report.held.resize(program.entries.size());
    findTargets(program, law_dt_s, state, report);
    if (program.needs.choice) keepNearest(report.held);
    const bool stopped = state.gate.fault.kind != FaultKind::None && !input.restart;
    const bool idle = stopped || (!input.engage && state.gate.level == 0.0);
    report.f_T_W = sumForces(program, way_T_W, state, report, {law_dt_s, state.limited, idle});
    smoothOver(law_dt_s, idle, state, report.f_T_W);
    state.time_ns = input.sample.time_ns;
    state.has_time = true;
  }
  report.p_WT = state.p_WT;
  const safety::Asked asked{report.f_T_W, input.engage, input.restart, fault, input.late, motion, time.waited_s};
  const safety::Gated gated = safety::gate(program.limits, state.gate, asked, time.dt_s);
  state.gate = gated.next;
  report.force = gated.force;
  report.level = gated.next.level;
  report.cuts = gated.cuts;
  report.cut_N = safety::sumOf(gated.cuts);
  report.v_WT = gated.next.v_WT;
  report.heat = gated.next.heat;
  report.fault = gated.fault;
  state.limited = report.cut_N > 0.0 || gated.next.level < 1.0;
}

}  // namespace underact::tick
