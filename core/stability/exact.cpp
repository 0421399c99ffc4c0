#include "core/stability/exact.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>

#include "core/base/decompositions.h"
#include "core/base/units.h"

namespace underact::stability {
namespace {

using Matrix = Eigen::MatrixXd;
using Row = Eigen::RowVectorXd;

constexpr Eigen::Index kMemory = 2;  // of each filter

/// A filter as s' = A s + b x, dx/dt = c s + d x.
struct LinearFilter {
  Eigen::Matrix2d A;
  Eigen::Vector2d b;
  Eigen::RowVector2d c;
  double d = 0.0;
};

/// First order on the raw difference, backward Euler; time_constant_s 0: the raw difference. s: the last x, the rate.
LinearFilter lowPass(double time_constant_s, double period_s) {
  const double share = period_s / (period_s + time_constant_s);
  LinearFilter filter;
  filter.A.setZero();
  filter.A.row(1) << -share / period_s, 1.0 - share;
  filter.b = Eigen::Vector2d(1.0, share / period_s);
  filter.c = filter.A.row(1);
  filter.d = share / period_s;
  return filter;
}

/// The Kalman filter with its steady-state gains, by iteration of its covariance (in units of the noise's).
/// Source: Kalman 1960; the white acceleration of 1 ms is that of the law (control/velocity.h).
LinearFilter kalman(const control::Kalman& settings, double period_s) {
  const double T = period_s, ratio = settings.acceleration / settings.noise, q = ratio * ratio * 1e-3;
  const Eigen::Matrix2d F{{1.0, T}, {0.0, 1.0}}, Q{{q * T * T * T / 3, q * T * T / 2}, {q * T * T / 2, q * T}};
  Eigen::Matrix2d P = Eigen::Matrix2d::Identity();
  Eigen::Vector2d gain = Eigen::Vector2d::Zero();
  for (int n = 0; n < 100'000; ++n) {
    P = F * P * F.transpose() + Q;
    const Eigen::Vector2d next = P.col(0) / (P(0, 0) + 1.0);
    P -= next * P.row(0);
    const bool settled = (next - gain).norm() <= 1e-14 * next.norm();
    gain = next;
    if (settled) break;
  }
  LinearFilter filter;  // s: position and rate
  filter.A = F - gain * F.row(0);
  filter.b = gain;
  filter.c = filter.A.row(1);
  filter.d = gain[1];
  return filter;
}

LinearFilter filterOf(const SampledWall& wall) {
  if (const auto* low_pass = std::get_if<control::LowPass>(&wall.velocity))
    return lowPass(low_pass->time_constant_s, wall.period_s());
  if (const auto* settings = std::get_if<control::Kalman>(&wall.velocity)) return kalman(*settings, wall.period_s());
  return lowPass(0.0, wall.period_s());
}

/// The transfer function from x to dx/dt for x = z^n.
std::complex<double> rateOf(const LinearFilter& filter, const std::complex<double>& z) {
  const Eigen::Matrix2cd zI_A = z * Eigen::Matrix2cd::Identity() - filter.A;
  const Eigen::Vector2cd memory = zI_A.partialPivLu().solve(filter.b.cast<std::complex<double>>());
  return (filter.c.cast<std::complex<double>>() * memory)(0) + filter.d;
}

/// The map over a period of x, v and a constant force.
Mat3 motionOver(const SampledWall& wall) {
  Mat3 motion = Mat3::Zero();
  motion(0, 1) = 1.0;
  motion(1, 0) = -wall.hand_stiffness_N_per_m / wall.mass_kg;
  motion(1, 1) = -wall.damping_N_s_per_m / wall.mass_kg;
  motion(1, 2) = 1.0 / wall.mass_kg;
  const int halvings = std::max(0, std::ilogb(wall.period_s() * motion.cwiseAbs().maxCoeff()) + 8);
  Mat3 period = Mat3::Identity(), term = Mat3::Identity();
  for (int n = 1; n < 20; ++n) {
    term = term * motion * (std::ldexp(wall.period_s(), -halvings) / n);
    period += term;
  }
  for (int n = 0; n < halvings; ++n) period = period * period;
  return period;
}

/// The greatest K up to which is_ok holds, which it does at 0; none: it holds up to the maximum.
template <class IsOk>
std::optional<double> greatest(const IsOk& is_ok) {
  if (!is_ok(0.0)) return 0.0;
  double well = 0.0, ill = 1.0;
  while (ill <= kMaxStiffness_N_per_m && is_ok(ill)) {
    well = ill;
    ill *= 2.0;
  }
  if (ill > kMaxStiffness_N_per_m) return std::nullopt;
  for (int n = 0; n < 60; ++n) {
    const double middle = 0.5 * (well + ill);
    (is_ok(middle) ? well : ill) = middle;
  }
  return well;
}

/// The loop of a wall without its stiffness.
struct Loop {
  const SampledWall& wall;
  LinearFilter filter;
  Mat3 period;
};

Loop loopOf(const SampledWall& wall) {
  return {wall, filterOf(wall), motionOver(wall)};
}

double radiusOf(const Loop& loop, double stiffness_N_per_m) {
  const auto& [wall, filter, period] = loop;
  const Eigen::Index size = 2 + kMemory + wall.delay_ticks;
  Row asked = Row::Zero(size);
  asked[0] = -stiffness_N_per_m - wall.kd_N_s_per_m * filter.d;
  asked.segment<kMemory>(2) = -wall.kd_N_s_per_m * filter.c;
  Row acting = asked;
  if (wall.delay_ticks > 0) {
    acting.setZero();
    acting[size - 1] = 1.0;
  }
  Matrix step = Matrix::Zero(size, size);
  step.topLeftCorner(2, 2) = period.topLeftCorner<2, 2>();
  step.topRows(2) += period.block<2, 1>(0, 2) * acting;
  step.block<kMemory, 1>(2, 0) = filter.b;
  step.block<kMemory, kMemory>(2, 2) = filter.A;
  if (wall.delay_ticks > 0) step.row(2 + kMemory) = asked;
  for (Eigen::Index n = 3 + kMemory; n < size; ++n) step(n, n - 1) = 1.0;
  return eigenvaluesOf(step).cwiseAbs().maxCoeff();
}

}  // namespace

double spectralRadius(const SampledWall& wall, double stiffness_N_per_m) {
  return radiusOf(loopOf(wall), stiffness_N_per_m);
}

std::optional<double> exactLimit(const SampledWall& wall) {
  if (!wall.isLinear()) return std::nullopt;
  // A free mass keeps its position and does not oscillate: the search begins with the least stiffness.
  return greatest([loop = loopOf(wall)](double K) { return radiusOf(loop, std::max(K, 1e-3)) < 1.0; });
}

double passiveLimit(const SampledWall& wall) {
  constexpr int kFrequencies = 2000;
  const LinearFilter filter = filterOf(wall);
  const double T = wall.period_s();
  double limit = kMaxStiffness_N_per_m;
  for (int n = 1; n <= kFrequencies; ++n) {
    const double omega = kPi / T * n / kFrequencies;
    const std::complex<double> z = std::polar(1.0, omega * T);
    // b >= T/2 / (1 - cos omega T) Re((1 - 1/z) H), H = (K + B rate) / z^d: the damping required by each of K and B.
    const std::complex<double> asks =
        0.5 * T / (1.0 - std::cos(omega * T)) * (1.0 - 1.0 / z) * std::pow(z, -wall.delay_ticks);
    const double left = wall.damping_N_s_per_m - wall.kd_N_s_per_m * (asks * rateOf(filter, z)).real();
    if (left < 0.0) return 0.0;
    if (asks.real() > 0.0) limit = std::min(limit, left / asks.real());
  }
  return limit;
}

double colgateSchenkel(const SampledWall& wall) {
  return std::max(0.0, 2.0 * (wall.damping_N_s_per_m - std::abs(wall.kd_N_s_per_m)) / wall.period_s());
}

double gilHulin(const SampledWall& wall) {
  return std::max(0.0, (wall.damping_N_s_per_m + wall.kd_N_s_per_m) / (wall.period_s() * (0.5 + wall.delay_ticks)));
}

}  // namespace underact::stability
