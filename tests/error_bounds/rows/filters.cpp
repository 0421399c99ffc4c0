#include <array>

#include "core/control/velocity.h"
#include "tests/error_bounds/oracle/real.h"
#include "tests/error_bounds/rows/draws.h"
#include "tests/error_bounds/rows/rows.h"

namespace underact::error_bounds {
namespace filters_rows {

using control::Velocity;
using control::VelocityState;

constexpr int kSamples = 96;

/// One axis of a signal for the oracles, and the scale of its differences.
struct Samples {
  std::vector<Real> e, dt;
  Real fastest = 0;  // of all differences over their time
  Real largest = 0;  // of all samples
  Real shortest = 0;
};
Samples samplesOf(const Signal& signal, Eigen::Index axis) {
  Samples samples;
  for (std::size_t i = 0; i < signal.e_W.size(); ++i) {
    samples.e.emplace_back(signal.e_W[i][axis]);
    samples.dt.emplace_back(signal.dt_s[i]);
    samples.largest = std::max(samples.largest, Real(abs(samples.e.back())));
    if (i == 0 || samples.dt[i] == 0) continue;
    samples.fastest = std::max(samples.fastest, Real(abs(samples.e[i] - samples.e[i - 1]) / samples.dt[i]));
    if (samples.shortest == 0 || samples.dt[i] < samples.shortest) samples.shortest = samples.dt[i];
  }
  return samples;
}

Vec3 rateAfter(const Velocity& velocity, const Signal& signal) {
  return asTheServo([&] {
    VelocityState state;
    for (std::size_t i = 0; i < signal.e_W.size(); ++i) updateRate(velocity, state, signal.e_W[i], signal.dt_s[i]);
    return state.rate_W;
  });
}

/// The largest error of the last rate over the axes; rightOf gives the right one and its scale.
template <class RightOf>
Outcome compareRates(const Velocity& velocity, const Signal& signal, const RightOf& rightOf) {
  const Vec3 got = rateAfter(velocity, signal);
  double worst = 0.0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto [right, scale] = rightOf(samplesOf(signal, axis), axis);
    worst = std::max(worst, ulpsOf(got[axis], right, scale));
  }
  return {worst, false};
}

Outcome judgeLowPass(Input& input) {
  const double tau_s =
      input.number("time_constant_s", [](Dice& dice) { return dice.one(2) ? 1.6e-3 : dice.power(-20, 4); });
  const Signal signal = drawSignal(input, kSamples);
  return compareRates(control::LowPass{tau_s}, signal, [&](const Samples& samples, Eigen::Index) {
    // Not step by step: each difference, with what the later steps have left of it.
    Real right = 0, left = 1;
    for (std::size_t i = samples.e.size() - 1; i > 0; --i) {
      if (samples.dt[i] == 0) continue;
      right += left * (samples.e[i] - samples.e[i - 1]) / (samples.dt[i] + tau_s);
      left *= tau_s / (samples.dt[i] + tau_s);
    }
    const Real memory = std::min(Real(tau_s / samples.shortest), Real(kSamples));
    return std::pair(right, Real(samples.fastest * (1 + memory)));
  });
}

Outcome judgeRaw(Input& input) {
  const Signal signal = drawSignal(input, 8);
  return compareRates(control::RawDifference{}, signal, [&](const Samples& samples, Eigen::Index) {
    Real right = 0;
    for (std::size_t i = samples.e.size() - 1; i > 0 && right == 0; --i) {
      if (samples.dt[i] == 0) continue;
      right = (samples.e[i] - samples.e[i - 1]) / samples.dt[i];
      break;
    }
    return std::pair(right, Real(abs(right)));
  });
}

/// Least squares about the mean, over the last n + 1 samples.
Real slopeOver(const std::vector<Real>& t, const std::vector<Real>& e, std::size_t n) {
  Real mean_t = 0, mean_e = 0, tt = 0, te = 0;
  for (std::size_t k = 0; k <= n; ++k) mean_t += t[k], mean_e += e[k];
  mean_t /= static_cast<double>(n + 1), mean_e /= static_cast<double>(n + 1);
  for (std::size_t k = 0; k <= n; ++k) {
    tt += (t[k] - mean_t) * (t[k] - mean_t);
    te += (t[k] - mean_t) * (e[k] - mean_e);
  }
  return te / tt;
}

/// Whether the line through the newest and the n-th sample passes every one between them within noise.
bool fits(const std::vector<Real>& t, const std::vector<Real>& e, std::size_t n, const Real& noise) {
  const Real slope = (e[n] - e[0]) / (t[n] - t[0]);
  for (std::size_t k = 1; k < n; ++k) {
    if (abs(e[0] + slope * (t[k] - t[0]) - e[k]) > noise) return false;
  }
  return true;
}

Outcome judgeWindow(Input& input) {
  control::AdaptiveWindow window;
  window.window = static_cast<int>(1 + input.choice("window", control::kLongestWindow));
  Signal signal = drawSignal(input, kSamples);
  const double noise = input.number("noise", [&](Dice& dice) {
    return dice.one(8) ? 0.0 : (signal.e_W[1] - signal.e_W[0]).norm() * dice.power(-6, 8);
  });
  window.noise.setConstant(noise);
  while (signal.dt_s.size() > 2 && signal.dt_s.back() == 0.0) {  // without time the rate stays as it is
    signal.dt_s.pop_back();
    signal.e_W.pop_back();
  }
  const Vec3 got = rateAfter(window, signal);
  double worst = 0.0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Samples samples = samplesOf(signal, axis);
    std::vector<Real> t, e;  // newest first; where no time passed the later sample stands
    Real back = 0;
    for (std::size_t i = samples.e.size(); i-- > 0;) {
      if (e.empty() || samples.dt[i + 1] > 0) t.push_back(back), e.push_back(samples.e[i]);
      back -= samples.dt[i];
    }
    // The longest good window; where rounding decides about a sample, either choice is right.
    const Real lenient = ldexp(samples.largest, -44) + ldexp(Real(noise), -44) + 1e-300;
    double best = kInfinity;
    const auto longest = static_cast<std::size_t>(window.window);
    for (std::size_t n = 1; n <= longest && n < e.size(); ++n) {
      if (!fits(t, e, n, noise + lenient)) break;
      const bool may_end = n == longest || n + 1 >= e.size() || !fits(t, e, n + 1, noise - lenient);
      const Real scale = samples.largest / (t[0] - t[n]) + samples.fastest;
      if (may_end) best = std::min(best, ulpsOf(got[axis], slopeOver(t, e, n), scale));
    }
    worst = std::max(worst, best);
  }
  return {worst, false};
}

/// The textbook filter: P = F P F^T + Q, gain, and P in Joseph's form; in units of the noise.
Real kalmanRate(const Samples& samples, const Real& ratio) {
  const Real white = ratio * ratio * Real(1e-3);
  Real place = samples.e[0], rate = 0, a = 1, b = 0, d = 0;
  for (std::size_t i = 1; i < samples.e.size(); ++i) {
    const Real& dt = samples.dt[i];
    if (dt == 0) {
      place = samples.e[i];
      continue;
    }
    const Real q = white * dt;
    const Real aa = a + 2 * dt * b + dt * dt * d + q * dt * dt / 3, bb = b + dt * d + q * dt / 2, dd = d + q;
    const Real gain_place = aa / (aa + 1), gain_rate = bb / (aa + 1);
    const Real surprise = samples.e[i] - place - dt * rate;
    place += dt * rate + gain_place * surprise;
    rate += gain_rate * surprise;
    const Real keep = 1 - gain_place;
    a = keep * keep * aa + gain_place * gain_place;
    b = keep * (bb - gain_rate * aa) + gain_place * gain_rate;
    d = dd - 2 * gain_rate * bb + gain_rate * gain_rate * (aa + 1);
  }
  return rate;
}

Outcome judgeKalman(Input& input) {
  control::Kalman kalman;
  kalman.noise = input.number("noise", [](Dice& dice) { return dice.one(2) ? 1.6e-5 : dice.scale(); });
  kalman.acceleration = input.number("acceleration", [](Dice& dice) { return dice.one(2) ? 8.0 : dice.scale(); });
  const Signal signal = drawSignal(input, kSamples);
  return compareRates(kalman, signal, [&](const Samples& samples, Eigen::Index) {
    const Real right = kalmanRate(samples, Real(kalman.acceleration) / kalman.noise);
    return std::pair(right, Real(samples.largest / samples.shortest + samples.fastest));
  });
}

constexpr std::array<Row, 4> kRows{{
    {"rate_low_pass", Kind::Filter, "First-order low-pass over 96 samples, 1 Hz to 100 kHz",
     "ulp of the fastest difference times (1 + time constant / shortest tick, 96 at most)", 8, 12, judgeLowPass},
    {"rate_raw", Kind::Filter, "Raw difference", "ulp of the rate", 2, 1, judgeRaw},
    {"rate_window", Kind::Filter, "Adaptive window over 96 samples: its length by end-fit, its slope",
     "ulp of the largest sample over the window's time, and of the fastest difference", 256, 5, judgeWindow},
    {"rate_kalman", Kind::Filter, "Kalman's filter over 96 samples",
     "ulp of the largest sample over the shortest tick, and of the fastest difference", 64, 25, judgeKalman},
}};

}  // namespace filters_rows

constinit const std::span<const Row> kFilterRows = filters_rows::kRows;

}  // namespace underact::error_bounds
