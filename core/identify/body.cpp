#include "core/identify/body.h"

#include <cmath>

namespace underact::identify {
namespace {

// Below this the series is as exact as a double; above it expm1 does not cancel. z^6 / 5040 at 0.01 is 2e-16.
constexpr double kSmallDecay = 0.01;
constexpr int kMaxTurns = 4;  // a constant force reverses a body at most once; then it sticks or moves on

}  // namespace

BodyStep::BodyStep(const Body& body, double period_s)
    : body_(body),
      period_s_(period_s),
      decay_per_s_(body.damping_N_s_per_m / body.mass_kg),
      whole_(reachAfter(period_s)) {}

// With z = b t / m: t (1 - e^-z) / z and t^2 (z - 1 + e^-z) / z^2, the solutions of x'' = a - (b / m) x'.
BodyStep::Reach BodyStep::reachAfter(double time_s) const {
  const double z = decay_per_s_ * time_s;
  if (std::abs(z) < kSmallDecay) {
    const double first = 1.0 - z / 2.0 * (1.0 - z / 3.0 * (1.0 - z / 4.0 * (1.0 - z / 5.0 * (1.0 - z / 6.0))));
    const double second = 0.5 - z / 6.0 * (1.0 - z / 4.0 * (1.0 - z / 5.0 * (1.0 - z / 6.0)));
    return {time_s * first, time_s * time_s * second};
  }
  const double first = -std::expm1(-z) / z;
  return {time_s * first, time_s * time_s * (1.0 - first) / z};
}

Motion BodyStep::gone(const Motion& motion, double acceleration, const Reach& reach) const {
  return {motion.x_m + motion.v_m_per_s * reach.of_velocity_s + acceleration * reach.of_acceleration_s2,
          motion.v_m_per_s + (acceleration - decay_per_s_ * motion.v_m_per_s) * reach.of_velocity_s};
}

Motion BodyStep::operator()(Motion motion, double force_N, double friction_share) const {
  const double friction_N = friction_share * body_.friction_N;
  const double pull_N = force_N + body_.bias_N;
  double left_s = period_s_;
  for (int turn = 0; turn < kMaxTurns; ++turn) {
    if (motion.v_m_per_s == 0.0 && std::abs(pull_N) <= friction_N) return motion;
    const double sign = std::copysign(1.0, motion.v_m_per_s != 0.0 ? motion.v_m_per_s : pull_N);
    const double acceleration = (pull_N - sign * friction_N) / body_.mass_kg;
    const Motion end = gone(motion, acceleration, left_s == period_s_ ? whole_ : reachAfter(left_s));
    if (sign * end.v_m_per_s >= 0.0) return end;
    // v(t) = 0 where e^-(b/m)t = a / (a - (b/m) v); without damping where t = -v / a.
    const double share = -motion.v_m_per_s * decay_per_s_ / acceleration;
    const double turn_s = std::abs(share) < 1e-9 ? -motion.v_m_per_s / acceleration : std::log1p(share) / decay_per_s_;
    motion = {gone(motion, acceleration, reachAfter(turn_s)).x_m, 0.0};
    left_s -= turn_s;
    if (!(left_s > 0.0)) return motion;
  }
  return motion;
}

}  // namespace underact::identify
