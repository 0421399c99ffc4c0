#include "core/control/law.h"

#include <algorithm>

namespace underact::control {
namespace {

void followRate(LawState& state, const Vec3& e_W, double dt_s) noexcept UNDERACT_REAL_TIME {
  if (state.has_last && dt_s > 0.0) {
    const Vec3 raw_W = (e_W - state.e_last_W) / dt_s;
    state.rate_W += (dt_s / (dt_s + kRateFilter_s)) * (raw_W - state.rate_W);
  }
  state.e_last_W = e_W;
  state.has_last = true;
}

void integrate(const PID& law, LawState& state, const Vec3& e_W, const Vec3& others_T_W,
               const Moment& moment) noexcept UNDERACT_REAL_TIME {
  if (moment.idle) {
    state.integral_T_W.setZero();
    return;
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double added_N = law.ki_N_per_m_s[axis] * e_W[axis] * moment.dt_s;
    const double so_far_N = others_T_W[axis] + state.integral_T_W[axis];
    if (!(moment.limited && added_N * so_far_N > 0.0)) state.integral_T_W[axis] += added_N;
  }
  const double size_N = state.integral_T_W.norm();
  if (size_N > law.integral_limit_N) state.integral_T_W *= law.integral_limit_N / size_N;
}

}  // namespace

Vec3 force(const Law& law, LawState& state, const Vec3& e_W, const Moment& moment) noexcept {
  if (const P* p = std::get_if<P>(&law)) return p->kp_N_per_m.cwiseProduct(e_W);
  followRate(state, e_W, moment.dt_s);
  if (const PD* pd = std::get_if<PD>(&law)) {
    return pd->kp_N_per_m.cwiseProduct(e_W) + pd->kd_N_s_per_m.cwiseProduct(state.rate_W);
  }
  if (const PID* pid = std::get_if<PID>(&law)) {
    const Vec3 others_T_W = pid->kp_N_per_m.cwiseProduct(e_W) + pid->kd_N_s_per_m.cwiseProduct(state.rate_W);
    integrate(*pid, state, e_W, others_T_W, moment);
    return others_T_W + state.integral_T_W;
  }
  return Vec3::Zero();
}

void rest(LawState& state, bool lost) noexcept {
  state.e_last_W.setZero();
  state.rate_W.setZero();
  state.has_last = !lost;
  if (!lost) state.integral_T_W.setZero();
}

bool needsRate(const Law& law) {
  return !std::holds_alternative<P>(law);
}

bool needsIntegral(const Law& law) {
  return std::holds_alternative<PID>(law);
}

const Vec3& stiffness(const Law& law) {
  return std::visit([](const auto& chosen) -> const Vec3& { return chosen.kp_N_per_m; }, law);
}

}  // namespace underact::control
