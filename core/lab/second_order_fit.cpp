#include "core/lab/second_order_fit.h"

#include <algorithm>
#include <cmath>

#include "core/base/decompositions.h"
#include "core/base/trig.h"
#include "core/base/types.h"
#include "core/base/units.h"

namespace underact::lab {
namespace {

constexpr std::size_t kFewestToFit = 10;
constexpr std::size_t kCoarse = 600;  // samples used by the grid
constexpr int kFrequencies = 80, kDampings = 24;
constexpr int kSteps = 100;
constexpr double kMinZeta = 1e-4, kMaxZeta = 50.0;

/// sin(x) / x.
double sinc(double x) {
  return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : sinCos(x).sin / x;
}

/// A curve relative to its first value, every stride-th sample of it, and its distance from the response for a pair of
/// parameters.
class Distance {
 public:
  using Parameters = Eigen::Vector2d;  // logarithms of omega_n and zeta

  Distance(const SampledResponse& curve, std::size_t stride) {
    for (std::size_t index = 0; index < curve.value.size(); index += stride) {
      time_s_.push_back(curve.period_s * static_cast<double>(index));
      value_.push_back(curve.value[index] - curve.value.front());
    }
  }
  /// The best gain, the sum of squares with it, and the fit as numbers.
  SecondOrderFit at(const Parameters& parameters) const {
    SecondOrderFit fit{std::exp(parameters[0]), std::exp(parameters[1])};
    const Eigen::VectorXd shape = shapeOf(parameters);
    const Eigen::Map<const Eigen::VectorXd> value(value_.data(), shape.size());
    const double size = shape.squaredNorm();
    fit.gain = size > 0.0 ? shape.dot(value) / size : 0.0;
    fit.residual = std::sqrt((value - fit.gain * shape).squaredNorm() / static_cast<double>(shape.size()));
    return fit;
  }
  /// One Levenberg-Marquardt step over frequency, damping and gain.
  Parameters step(const Parameters& parameters, double gain, double damping) const {
    constexpr double kNudge = 1e-6;
    const Eigen::VectorXd shape = shapeOf(parameters);
    Eigen::MatrixXd slope(shape.size(), 3);
    for (Eigen::Index index = 0; index < 2; ++index) {
      const Parameters nudge = kNudge * Parameters::Unit(index);
      slope.col(index) = gain / (2.0 * kNudge) * (shapeOf(parameters + nudge) - shapeOf(parameters - nudge));
    }
    slope.col(2) = shape;
    const Eigen::Map<const Eigen::VectorXd> value(value_.data(), shape.size());
    Mat3 normal = slope.transpose() * slope;
    normal.diagonal() *= 1.0 + damping;
    const Vec3 offset = solveSymmetric(normal, slope.transpose() * (value - gain * shape));
    return parameters + offset.head<2>();
  }

 private:
  Eigen::VectorXd shapeOf(const Parameters& parameters) const {
    const double omega = std::exp(parameters[0]), zeta = std::exp(parameters[1]);
    Eigen::VectorXd shape(static_cast<Eigen::Index>(time_s_.size()));
    for (std::size_t index = 0; index < time_s_.size(); ++index)
      shape[static_cast<Eigen::Index>(index)] = secondOrderAt(omega, zeta, time_s_[index]);
    return shape;
  }

  std::vector<double> time_s_, value_;
};

double shareOf(int index, int count, double from, double to) {
  return from + (to - from) * index / (count - 1);
}

Distance::Parameters bestOfGrid(const Distance& distance, const Distance::Parameters& low,
                                const Distance::Parameters& high) {
  Distance::Parameters best = low;
  double min = kInfinity;
  for (int frequency = 0; frequency < kFrequencies; ++frequency) {
    for (int damping = 0; damping < kDampings; ++damping) {
      const Distance::Parameters tried(shareOf(frequency, kFrequencies, low[0], high[0]),
                                       shareOf(damping, kDampings, std::log(0.02), std::log(20.0)));
      const double residual = distance.at(tried).residual;
      if (residual >= min) continue;
      min = residual;
      best = tried;
    }
  }
  return best;
}

}  // namespace

double secondOrderAt(double omega_n_rad_per_s, double zeta, double t_s) noexcept {
  const double x = omega_n_rad_per_s * t_s;
  const double d = std::sqrt(std::abs(1.0 - zeta * zeta));
  if (zeta < 1.0) return 1.0 - std::exp(-zeta * x) * (sinCos(d * x).cos + zeta * x * sinc(d * x));
  if (d * x < 1e-3) {  // cosh and sinh to their second terms
    const double square = d * x * d * x;
    return 1.0 - std::exp(-zeta * x) * (1.0 + square / 2.0 + zeta * x * (1.0 + square / 6.0));
  }
  const double fast = zeta + d, slow = 1.0 / fast;
  return 1.0 - (fast * std::exp(-slow * x) - slow * std::exp(-fast * x)) / (fast - slow);
}

std::optional<SecondOrderFit> fitSecondOrder(const SampledResponse& curve) {
  const std::vector<double>& value = curve.value;
  if (value.size() < kFewestToFit) return {};
  const auto [min, max] = std::minmax_element(value.begin(), value.end());
  if (*min == *max) return {};
  const double length_s = curve.period_s * static_cast<double>(value.size() - 1);
  const Distance::Parameters low(std::log(0.5 * kPi / length_s), std::log(kMinZeta));
  const Distance::Parameters high(std::log(kPi / curve.period_s), std::log(kMaxZeta));
  Distance::Parameters at = bestOfGrid(Distance(curve, 1 + value.size() / kCoarse), low, high);
  const Distance distance(curve, 1);
  SecondOrderFit fit = distance.at(at);
  double damping = 1e-3;
  for (int step = 0; step < kSteps && damping < 1e12; ++step) {
    const Distance::Parameters next = distance.step(at, fit.gain, damping).cwiseMax(low).cwiseMin(high);
    const SecondOrderFit tried = distance.at(next);
    if (tried.residual < fit.residual) {
      const double gained = fit.residual - tried.residual;
      at = next;
      fit = tried;
      damping *= 0.1;
      if (gained < 1e-12 * fit.residual) break;
    } else {
      damping *= 10.0;
    }
  }
  return fit;
}

}  // namespace underact::lab
