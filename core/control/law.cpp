#include "core/control/law.h"

#include <algorithm>

namespace underact::control {
namespace {

void integrate(const PID& law, LawState& state, const Vec3& e_W, const Vec3& others_T_W,
               const LawInput& moment) noexcept UNDERACT_REAL_TIME {
  if (moment.idle) {
    state.integral_T_W.setZero();
    return;
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (!(law.ki_N_per_m_s[axis] > 0.0)) {  // without a gain nothing would unwind it
      state.integral_T_W[axis] = 0.0;
      continue;
    }
    const double added_N = law.ki_N_per_m_s[axis] * e_W[axis] * moment.dt_s;
    const double so_far_N = others_T_W[axis] + state.integral_T_W[axis];
    if (!(moment.limited && added_N * so_far_N > 0.0)) state.integral_T_W[axis] += added_N;
  }
  const double size_N = state.integral_T_W.norm();
  if (size_N > law.integral_limit_N) state.integral_T_W *= law.integral_limit_N / size_N;
}

/// kp e + kd de/dt.
Vec3 springAndDamper(const Vec3& kp_N_per_m, const Vec3& kd_N_s_per_m, const VelocityState& velocity,
                     const Vec3& e_W) noexcept UNDERACT_REAL_TIME {
  return kp_N_per_m.cwiseProduct(e_W) + kd_N_s_per_m.cwiseProduct(velocity.rate_W);
}

}  // namespace

Vec3 force(const P& law, const Vec3& e_W) noexcept {
  return law.kp_N_per_m.cwiseProduct(e_W);
}

Vec3 force(const Law& law, LawState& state, const Vec3& e_W, const LawInput& moment) noexcept {
  if (const P* p = std::get_if<P>(&law)) return force(*p, e_W);
  if (const PD* pd = std::get_if<PD>(&law)) {
    updateRate(pd->velocity, state.velocity, e_W, moment.dt_s);
    state.integral_T_W.setZero();  // left by an earlier PID: must not return with the next one
    return springAndDamper(pd->kp_N_per_m, pd->kd_N_s_per_m, state.velocity, e_W);
  }
  if (const PID* pid = std::get_if<PID>(&law)) {
    updateRate(pid->velocity, state.velocity, e_W, moment.dt_s);
    const Vec3 others_T_W = springAndDamper(pid->kp_N_per_m, pid->kd_N_s_per_m, state.velocity, e_W);
    integrate(*pid, state, e_W, others_T_W, moment);
    return others_T_W + state.integral_T_W;
  }
  return Vec3::Zero();
}

void rest(LawState& state, bool lost) noexcept {
  if (lost) {
    reset(state.velocity);
    return;
  }
  resetToZero(state.velocity);
  state.integral_T_W.setZero();
}

void reset(LawState& state) noexcept {
  reset(state.velocity);
  state.integral_T_W.setZero();
}

bool needsRate(const Law& law) {
  return !std::holds_alternative<P>(law);
}

bool needsIntegral(const Law& law) {
  return std::holds_alternative<PID>(law);
}

const Vec3& stiffness(const Law& law) noexcept {
  if (const PD* pd = std::get_if<PD>(&law)) return pd->kp_N_per_m;
  if (const PID* pid = std::get_if<PID>(&law)) return pid->kp_N_per_m;
  return std::get_if<P>(&law)->kp_N_per_m;
}

}  // namespace underact::control
