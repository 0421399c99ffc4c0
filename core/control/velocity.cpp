#include "core/control/velocity.h"

#include <algorithm>

#include "core/base/valid_bytes.h"

namespace underact::control {
namespace {

constexpr double kWhite_s = 1e-3;  // the time for which an acceleration holds in the Kalman model

void filter(const LowPass& low_pass, VelocityState& state, const Vec3& e_W, double dt_s) noexcept UNDERACT_REAL_TIME {
  if (!state.has_last || !(dt_s > 0.0)) return;
  const Vec3 raw_W = (e_W - state.e_last_W) / dt_s;
  state.rate_W += (dt_s / (dt_s + low_pass.time_constant_s)) * (raw_W - state.rate_W);
}

void filter(const RawDifference&, VelocityState& state, const Vec3& e_W, double dt_s) noexcept UNDERACT_REAL_TIME {
  if (state.has_last && dt_s > 0.0) state.rate_W = (e_W - state.e_last_W) / dt_s;
}

void put(Window& window, const Vec3& e_W) noexcept UNDERACT_REAL_TIME {
  const auto at = static_cast<std::size_t>(window.newest);
  for (std::size_t axis = 0; axis < 3; ++axis) window.e_W[axis][at] = e_W[static_cast<Eigen::Index>(axis)];
}

void push(Window& window, const Vec3& e_W, double after_s) noexcept UNDERACT_REAL_TIME {
  window.newest = window.newest < kLongestWindow ? window.newest + 1 : 0;
  put(window, e_W);
  window.after_s[static_cast<std::size_t>(window.newest)] = after_s;
  window.count = std::min(window.count + 1, kLongestWindow + 1);
}

void shift(Window& window, const Vec3& by_W) noexcept UNDERACT_REAL_TIME {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (double& e : window.e_W[axis]) e += by_W[static_cast<Eigen::Index>(axis)];
  }
}

/// The slope of one axis. A window of n ticks is good if the line through its ends passes every sample within noise,
/// that is, if its slope lies in the intersection of the slopes that the samples allow, seen from the newest one.
double slope(const Window& window, const Window::Row& past, int longest, double noise) noexcept UNDERACT_REAL_TIME {
  auto at = static_cast<std::size_t>(window.newest);
  const double newest = past[at];
  double lowest = -kInfinity, highest = kInfinity, back_s = 0.0;
  // Sums over the samples so far, relative to the newest, for the least squares.
  double count = 1.0, sum_t = 0.0, sum_e = 0.0, sum_tt = 0.0, sum_te = 0.0, best = 0.0;
  for (int n = 1; n <= longest && n < window.count; ++n) {
    back_s += window.after_s[at];
    at = at > 0 ? at - 1 : static_cast<std::size_t>(kLongestWindow);
    const double travel = newest - past[at];
    const double ends = travel / back_s;
    if (!(ends >= lowest && ends <= highest)) break;
    lowest = std::max(lowest, (travel - noise) / back_s);
    highest = std::min(highest, (travel + noise) / back_s);
    count += 1.0;
    sum_t += back_s;
    sum_e += travel;
    sum_tt += back_s * back_s;
    sum_te += back_s * travel;
    best = n == 1 ? ends : (count * sum_te - sum_t * sum_e) / (count * sum_tt - sum_t * sum_t);
  }
  return best;
}

void filter(const AdaptiveWindow& adaptive, VelocityState& state, const Vec3& e_W,
            double dt_s) noexcept UNDERACT_REAL_TIME {
  Window& window = state.window;
  if (!state.has_last) shift(window, e_W - dt_s * state.rate_W - state.e_last_W);
  if (window.count > 0 && !(dt_s > 0.0)) {
    put(window, e_W);
    return;
  }
  push(window, e_W, dt_s);
  if (!state.has_last || window.count < 2) return;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    state.rate_W[axis] =
        slope(window, window.e_W[static_cast<std::size_t>(axis)], adaptive.window, adaptive.noise[axis]);
  }
}

void filter(const Kalman& kalman, VelocityState& state, const Vec3& e_W, double dt_s) noexcept UNDERACT_REAL_TIME {
  if (!state.has_last || !(dt_s > 0.0)) {
    state.place_W = e_W;
    return;
  }
  const double ratio = kalman.acceleration / kalman.noise;
  const double drift = ratio * ratio * kWhite_s * dt_s;
  auto& [place, both, rate] = state.spread;
  place += dt_s * (2.0 * both + dt_s * (rate + drift / 3.0));
  both += dt_s * (rate + drift / 2.0);
  rate += drift;
  const double gain_place = place / (place + 1.0), gain_rate = both / (place + 1.0);
  const Vec3 expected_W = state.place_W + dt_s * state.rate_W;
  const Vec3 surprise_W = e_W - expected_W;
  state.place_W = expected_W + gain_place * surprise_W;
  state.rate_W += gain_rate * surprise_W;
  rate -= gain_rate * both;
  both *= 1.0 - gain_place;
  place *= 1.0 - gain_place;
}

/// Prepares the state of a filter after a change of filters: the last position and rate, and a uniform motion before
/// it.
void takeOver(VelocityState& state, double dt_s) noexcept UNDERACT_REAL_TIME {
  state.place_W = state.e_last_W;
  state.spread[0] = 1.0;
  state.spread[1] = state.spread[2] = 0.0;
  state.window.count = 0;
  if (!state.has_last || !(dt_s > 0.0)) return;
  for (int n = kLongestWindow; n >= 0; --n) push(state.window, state.e_last_W - (n * dt_s) * state.rate_W, dt_s);
}

}  // namespace

void updateRate(const Velocity& velocity, VelocityState& state, const Vec3& e_W, double dt_s) noexcept {
  const auto filter_now = static_cast<std::uint8_t>(velocity.index());
  if (filter_now != state.filter) takeOver(state, dt_s);
  state.filter = filter_now;
  if (const auto* low_pass = std::get_if<LowPass>(&velocity)) filter(*low_pass, state, e_W, dt_s);
  if (const auto* raw = std::get_if<RawDifference>(&velocity)) filter(*raw, state, e_W, dt_s);
  if (const auto* adaptive = std::get_if<AdaptiveWindow>(&velocity)) filter(*adaptive, state, e_W, dt_s);
  if (const auto* kalman = std::get_if<Kalman>(&velocity)) filter(*kalman, state, e_W, dt_s);
  state.e_last_W = e_W;
  state.has_last = true;
}

void resetToZero(VelocityState& state) noexcept {
  state.e_last_W.setZero();
  state.rate_W.setZero();
  state.has_last = true;
  state.place_W.setZero();
  state.window.count = 0;
  push(state.window, Vec3::Zero(), 0.0);
}

void reset(VelocityState& state) noexcept {
  state.e_last_W.setZero();
  state.rate_W.setZero();
  state.has_last = false;
  state.place_W.setZero();
  state.spread[0] = 1.0;
  state.spread[1] = state.spread[2] = 0.0;
  state.window.count = 0;
}

bool isValid(const VelocityState& state) noexcept {
  const Window& window = state.window;
  return isFlag(state.has_last) && state.filter < std::variant_size_v<Velocity> && window.newest >= 0 &&
         window.newest <= kLongestWindow && window.count >= 0 && window.count <= kLongestWindow + 1;
}

}  // namespace underact::control
