#include "core/tick/step.h"

#include <cmath>

#include "core/tick/forces.h"
#include "core/tick/motion.h"

namespace underact::tick {
namespace {

/// The longest pause that a law sees: after a longer one, rate and integral start as on a first tick.
constexpr double kLongestTick_s = 0.1;

Fault judge(const TickInput& input, const TickState& state, double dt_s) noexcept UNDERACT_REAL_TIME {
  if (input.fault.kind != FaultKind::None) return input.fault;
  if (!input.has_sample) return {FaultKind::NoSample, 0.0, 0.0};
  for (const double angle_rad : input.sample.q_rad) {
    if (!std::isfinite(angle_rad)) return {FaultKind::NotFinite, angle_rad, 0.0};
  }
  const double shin_rad = input.sample.q_rad[1] + input.sample.q_rad[2];  // the sum of two finite angles may overflow
  if (!std::isfinite(shin_rad)) return {FaultKind::NotFinite, shin_rad, 0.0};
  if (state.has_time && dt_s <= 0.0) return {FaultKind::StaleSample, dt_s, 0.0};
  return {};
}

/// Resets the report to that of a tick without results.
void begin(const TickProgram& program, const arm::Sample& sample, TickReport& report) noexcept UNDERACT_REAL_TIME {
  report.sample = sample;
  report.joints = program.needs.more_joints ? static_cast<int>(arm::jointsOf(program.geometry)) : 6;
  report.held.resize(0);
  report.R_WT.setIdentity();
  report.stylus_W.setZero();
  report.f_T_W.setZero();
  report.m_T_W.setZero();
  report.branch_changes = 0;
  report.out_of_reach = false;
  report.damping_m = 0.0;
}

void findTargets(const TickProgram& program, double dt_s, TickState& state,
                 TickReport& report) noexcept UNDERACT_REAL_TIME {
  report.held.resize(program.entries.size());
  for (std::size_t index = 0; index < report.held.size(); ++index) {
    ConstraintReport& held = report.held[index];
    const target::Target target =
        targetOf(program.entries[index].constraint, report.p_WT, report.R_WT, dt_s, state.entries[index].target, held);
    held.p_WP = target.p_WP;
    held.f_T_W.setZero();
    held.status = target.status;
    held.distance_m = target.distance_m;
    held.acts = target.status != target::Status::Free;
    held.energy_J = 0.0;
    held.f_passive_T_W.setZero();
  }
}

/// Leaves `acts` only at the nearest of the constraints that are touched; the first of equals.
void keepNearest(ConstraintReports& held) noexcept UNDERACT_REAL_TIME {
  std::size_t nearest = held.size();
  for (std::size_t index = 0; index < held.size(); ++index) {
    held[index].acts = false;
    if (held[index].status == target::Status::Free) continue;
    if (nearest == held.size() || held[index].distance_m < held[nearest].distance_m) nearest = index;
  }
  if (nearest < held.size()) held[nearest].acts = true;
}

/// Whether no force is sent at all.
bool isIdle(const TickInput& input, const safety::GateState& gate) noexcept UNDERACT_REAL_TIME {
  const bool stopped = gate.fault.kind != FaultKind::None && !input.restart;
  return stopped || (!input.engage && gate.level == 0.0);
}

/// Stores what the next tick is compared with.
void remember(const TickReport& report, TickState& state) noexcept UNDERACT_REAL_TIME {
  state.p_WT = report.p_WT;
  state.q_rad = report.sample.q_rad;
  state.time_ns = report.sample.time_ns;
  state.has_time = true;
}

void tell(const safety::Gated& gated, TickReport& report) noexcept UNDERACT_REAL_TIME {
  report.force = gated.force;
  report.level = gated.next.level;
  report.cuts = gated.cuts;
  report.cut_N = safety::sumOf(gated.cuts);
  report.v_WT = gated.next.v_WT;
  report.heat = Vec3(gated.next.heat[0], gated.next.heat[1], gated.next.heat[2]);
  report.fault = gated.fault;
}

}  // namespace

void step(const TickProgram& program, const TickInput& input, TickState& state, TickReport& report) noexcept {
  if (input.restart) {  // a complete new start: an arm that was unplugged counts its time from 0 again
    state.has_time = false;
    reset(state);
  }
  const double dt_s = secondsSince(state, input.sample.time_ns);
  const Fault fault = judge(input, state, dt_s);
  const bool is_good = fault.kind == FaultKind::None;
  const double law_dt_s = is_good && dt_s <= kLongestTick_s ? dt_s : 0.0;
  const GateTime time = gateTimeOf(input, state, dt_s, law_dt_s);
  safety::GateInput asked;
  begin(program, input.sample, report);
  if (is_good) {
    if (dt_s > kLongestTick_s) reset(state);
    computeKinematics(program, input.sample.q_rad, report, asked.motion);  // the targets depend on it
    computeMotion(input.sample.q_rad, state, time.motion_s, report.p_WT, asked.motion);
    findTargets(program, law_dt_s, state, report);
    if (program.needs.choice) keepNearest(report.held);
    const Vec3 displacement_T_W = law_dt_s > 0.0 ? Vec3(report.p_WT - state.p_WT) : Vec3(Vec3::Zero());
    const control::LawInput moment{law_dt_s, state.limited, isIdle(input, state.gate)};
    report.f_T_W = sumForces(program, moment, displacement_T_W, state, report);
    smoothForce(moment, state, report.f_T_W);
    if (program.needs.moment) report.m_T_W = sumMoments(report.held);
    if (input.push_T_W != Vec3::Zero()) report.f_T_W += input.push_T_W;  // it is no step of a law, and not smoothed
    remember(report, state);
  }
  report.p_WT = state.p_WT;
  asked.f_T_W = report.f_T_W;
  asked.m_T_W = report.m_T_W;
  asked.engage = input.engage;
  asked.restart = input.restart;
  asked.late = input.late;
  asked.fault = fault;
  asked.waited_s = time.waited_s;
  const safety::Gated gated = safety::gate(program.limits, state.gate, asked, time.dt_s);
  state.gate = gated.next;
  tell(gated, report);
  state.limited = report.cut_N > 0.0 || report.level < 1.0;
}

}  // namespace underact::tick
