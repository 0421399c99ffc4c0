#include "core/safety/gate.h"

#include <algorithm>
#include <cmath>

#include "core/base/norms.h"
#include "core/safety/stages.h"

namespace underact::safety {
namespace {

bool isMissing(const Fault& fault) noexcept UNDERACT_REAL_TIME {
  return fault.kind == FaultKind::NoSample || fault.kind == FaultKind::StaleSample;
}

/// The level of a ramp after dt_s. Time that stands, goes back or is not finite changes nothing; a ramp of 0 s is a
/// step.
double moved(double level, bool up, double dt_s, double ramp_s) noexcept UNDERACT_REAL_TIME {
  if (!(dt_s > 0.0)) return level;
  if (!(ramp_s > 0.0)) return up ? 1.0 : 0.0;
  return up ? std::min(level + dt_s / ramp_s, 1.0) : std::max(level - dt_s / ramp_s, 0.0);
}

}  // namespace

double travelTime_s(double by_arm_s, double by_servo_s) noexcept {
  constexpr double kMax = 4.0;
  return std::min(by_arm_s, kMax * by_servo_s);
}

Vec3 clampForce(const Vec3& f_T_W, double max_force_N) noexcept {
  if (!isFinite(f_T_W) || !(max_force_N > 0.0)) return Vec3::Zero();
  const double largest = largestOf(f_T_W);
  if (!(largest > 0.0)) return Vec3::Zero();
  const Vec3 shape = f_T_W / largest;  // so that no square overflows
  const double size = shape.norm();
  if (largest <= max_force_N / size) return f_T_W;
  return shape * (max_force_N / size);
}

namespace {

/// The fault of the sample, or one found from it.
Fault faultNow(const Limits& limits, const GateInput& asked) noexcept UNDERACT_REAL_TIME {
  if (asked.fault.kind != FaultKind::None) return asked.fault;
  if (!isFinite(asked.f_T_W) || !isFinite(asked.m_T_W)) return {FaultKind::NotFinite, 0.0, 0.0};
  const Vec3& v_WT = asked.motion.v_WT;
  if (v_WT.squaredNorm() > limits.max_jump_m_per_s * limits.max_jump_m_per_s)
    return {FaultKind::TooFast, sizeOf(v_WT), limits.max_jump_m_per_s};
  return {};
}

/// Counts late ticks while there is a force to release, and reports when there were too many.
void watchLateness(const Limits& limits, bool late, GateState& next) noexcept UNDERACT_REAL_TIME {
  next.late = late && next.level > 0.0 ? std::min(next.late, limits.max_late) + 1 : 0;
  if (next.late > limits.max_late && next.letting_go.kind == FaultKind::None)
    next.letting_go = {FaultKind::TooLate, static_cast<double>(next.late), static_cast<double>(limits.max_late)};
}

/// Applies one limit: the remaining force, and how much it took off.
Vec3 through(const Vec3& before_T_W, const Vec3& after_T_W, double& cut_N) noexcept UNDERACT_REAL_TIME {
  cut_N = after_T_W == before_T_W ? 0.0 : sizeOf(before_T_W - after_T_W);
  return after_T_W;
}

/// The motors a tick later, with what was sent.
void heatMotors(const Limits& limits, const Motion& motion, double passed_s,
                GateState& next) noexcept UNDERACT_REAL_TIME {
  next.heat = heated(limits.thermal, next.heat, motion, {next.f_T_W, next.m_T_W}, passed_s);
}

/// Scales both alike; a share of 1 leaves them.
void keep(double share, Wrench& wrench, double& cut_N) noexcept UNDERACT_REAL_TIME {
  if (!(share < 1.0)) return;
  wrench.m_T_W *= share;
  wrench.f_T_W = through(wrench.f_T_W, share * wrench.f_T_W, cut_N);
}

/// What the driven joints leave of both.
Wrench throughJoints(const Limits& limits, const Motion& motion, const Heat& heat, const Wrench& asked,
                     Cuts& cuts) noexcept UNDERACT_REAL_TIME {
  Wrench left = asked;
  if (motion.turns || !motion.renders_all) {
    left = limitMotors(motion, asked);
    through(asked.f_T_W, left.f_T_W, cuts.motors_N);
  }
  keep(edgeShare(limits, motion, left), left, cuts.edge_N);
  keep(torqueShare(limits, heat, motion, left), left, cuts.heat_N);
  return left;
}

/// The moment that a tick asks for, as far as the arm renders one and the tip is slow enough.
Vec3 momentOf(const Limits& limits, const GateInput& asked, const Vec3& v_WT) noexcept UNDERACT_REAL_TIME {
  if (!asked.motion.turns) return Vec3::Zero();
  return speedShare(limits, v_WT) * clampForce(asked.m_T_W, limits.max_moment_N_m);
}

/// Ramps, slows and counts it.
void sendMoment(const Limits& limits, const Vec3& asked_T_W, const Vec3& left_T_W, double dt_s, GateState& next,
                Cuts& cuts) noexcept UNDERACT_REAL_TIME {
  const Vec3 last_T_W = clampForce(next.m_T_W, limits.max_moment_N_m), ramped_T_W = next.level * left_T_W;
  Limits of_moment;
  of_moment.max_slew_N_per_s = kMomentArm_m * limits.max_slew_N_per_s;
  next.m_T_W = next.level > 0.0 ? limitSlew(of_moment, last_T_W, ramped_T_W, dt_s) : ramped_T_W;
  cuts.moment_N_m = sizeOf(asked_T_W - next.m_T_W);
}

Gated stopped(const Limits& limits, GateState next, const GateInput& asked, const Fault& now,
              double passed_s) noexcept UNDERACT_REAL_TIME {
  next.level = 0.0;
  next.late = 0;
  next.letting_go = {};
  next.f_T_W.setZero();
  next.m_T_W.setZero();
  heatMotors(limits, asked.motion, passed_s, next);
  return {GatedForce{}, next, {}, next.fault.kind != FaultKind::None ? next.fault : now};
}

}  // namespace

bool isValid(const GateState& state) noexcept {
  const auto isNumber = [](double heat) { return std::isfinite(heat); };
  const auto isKind = [](const Fault& fault) { return static_cast<int>(fault.kind) < kFaultKinds; };
  return state.level >= 0.0 && state.level <= 1.0 && state.missed >= 0 && state.late >= 0 && state.still_s >= 0.0 &&
         std::isfinite(state.still_s) && state.v_WT.allFinite() && state.f_T_W.allFinite() && state.m_T_W.allFinite() &&
         std::all_of(state.heat.begin(), state.heat.end(), isNumber) && isKind(state.letting_go) && isKind(state.fault);
}

Gated gate(const Limits& limits, const GateState& state, const GateInput& asked, double dt_s) noexcept {
  const double passed_s = dt_s + asked.waited_s;
  GateState next = state;
  if (asked.restart) {
    next = GateState{};
    next.heat = state.heat;  // motors cool by time alone
  }
  Fault now = faultNow(limits, asked);
  next.missed = isMissing(now) ? std::min(next.missed, limits.max_missed) + 1 : 0;
  if (now.kind == FaultKind::NoSample) {
    now.seen = next.missed;
    now.allowed = limits.max_missed;
  }
  const bool lasts = now.kind != FaultKind::None && (!isMissing(now) || next.missed > limits.max_missed);
  if (lasts && next.fault.kind == FaultKind::None) next.fault = now;
  watchLateness(limits, asked.late, next);
  if (next.letting_go.kind != FaultKind::None && next.level == 0.0 && next.fault.kind == FaultKind::None)
    next.fault = next.letting_go;
  if (now.kind != FaultKind::None || next.fault.kind != FaultKind::None)
    return stopped(limits, next, asked, now, passed_s);

  const Motion& motion = asked.motion;
  Cuts cuts;
  next.still_s = motion.moved ? 0.0 : next.still_s + std::max(0.0, passed_s);
  cuts.frozen = limits.frozen_s > 0.0 && next.still_s >= limits.frozen_s;
  const bool engage = asked.engage && !cuts.frozen && next.letting_go.kind == FaultKind::None;
  next.level =
      engage ? moved(next.level, true, dt_s, limits.rise_s) : moved(next.level, false, passed_s, limits.fall_s);
  next.v_WT = followVelocity(next.v_WT, motion.v_WT, passed_s);  // none after a Start
  Vec3 f_T_W = clampForce(asked.f_T_W, limits.max_force_N);
  if (f_T_W != asked.f_T_W) cuts.clamp_N = std::max(0.0, sizeOf(asked.f_T_W) - sizeOf(f_T_W));
  f_T_W = through(f_T_W, limitSpeed(limits, next.v_WT, f_T_W), cuts.speed_N);
  const Wrench left = throughJoints(limits, motion, next.heat, {f_T_W, momentOf(limits, asked, next.v_WT)}, cuts);
  const Vec3 ramped_T_W = next.level * left.f_T_W;
  Vec3 last_T_W = next.f_T_W;
  if (last_T_W.squaredNorm() > limits.max_force_N * limits.max_force_N)
    last_T_W = clampForce(last_T_W, limits.max_force_N);  // the limit may be lower in another scene
  next.f_T_W = ramped_T_W;
  if (next.level > 0.0)  // a release ends with its ramp, whatever the slew limit
    next.f_T_W = through(ramped_T_W, limitSlew(limits, last_T_W, ramped_T_W, engage ? dt_s : passed_s), cuts.slew_N);
  if (motion.turns)
    sendMoment(limits, asked.m_T_W, left.m_T_W, engage ? dt_s : passed_s, next, cuts);
  else
    next.m_T_W.setZero();
  heatMotors(limits, motion, passed_s, next);
  return {GatedForce{next.f_T_W, next.m_T_W}, next, cuts, Fault{}};
}

}  // namespace underact::safety
