#pragma once
#include <array>
#include <cmath>
#include <cstddef>

#include "core/base/real_time.h"
#include "core/shape/nearest.h"

namespace underact::shape {

/// The point of an axis-parallel ellipse (N = 2) or ellipsoid (N = 3) about the origin nearest to y, with its status.
template <std::size_t N>
struct OnQuadric {
  std::array<double, N> x{};
  Status status = Status::Unique;
  bool inside = false;
  double apart = 0.0;  // NotUnique: how far the mirrored points are
};

/// Newton's steps, at most; 4 to 8 in practice.
inline constexpr int kQuadricSteps = 40;

/// A lower bound of the s > 0 with (pole / s)^2 + beyond - slope s = 1, within a factor of 16.
/// Newton alone grows a start that is too small by half at each step, and a tip 1e-300 off the middle is 1e200 away
/// from it. Made of exponents and a square root: the same bits everywhere, and no square of 1e-300.
inline double quadricStart(double pole, double beyond, double slope) noexcept UNDERACT_REAL_TIME {
  if (!(pole > 0.0 && std::isfinite(pole) && std::isfinite(beyond) && std::isfinite(slope))) return 0.0;
  double start = kInfinity;  // where pole^2 = slope s^3 / 2, so that the slope alone says when to stop
  if (slope > 0.0) start = std::scalbn(1.0, (2 * std::ilogb(pole) - std::ilogb(slope) - 2) / 3 - 1);
  if (beyond < 1.0)
    start = std::fmin(start, pole / std::sqrt(2.0 * (1.0 - beyond)));  // and where the share left over does
  return std::isfinite(start) ? start : 0.0;
}

/// semi: the half axes, > 0; y: finite, same unit. NotUnique where mirrored points are equally near (the middle of the
/// thinnest axis). Cost: at most kQuadricSteps steps of Newton.
/// Source: Eberly, Distance from a point to an ellipse, an ellipsoid, or a hyperellipsoid (2013), with the unknown
/// counted from the pole of the smallest axis, to avoid cancellation there, and Newton from the left of the root, where
/// the function is convex and decreasing, so that no step overshoots.
template <std::size_t N>
OnQuadric<N> nearestOnQuadric(const std::array<double, N>& semi,
                              const std::array<double, N>& y) noexcept UNDERACT_REAL_TIME {
  double min = semi[0], size = 0.0;
  for (std::size_t i = 0; i < N; ++i) min = std::fmin(min, semi[i]);
  std::array<double, N> above{}, weighted{};  // semi^2 - least^2, and semi * |y|
  double at_pole = 0.0, pole = 0.0, beyond = 0.0, slope_there = 0.0, aside = 0.0, within = 0.0;
  for (std::size_t i = 0; i < N; ++i) {
    above[i] = (semi[i] - min) * (semi[i] + min);
    weighted[i] = semi[i] * std::abs(y[i]);
    size = std::fmax(size, std::abs(y[i]) + semi[i]);
    within += (y[i] / semi[i]) * (y[i] / semi[i]);
    if (above[i] > 0.0) {
      const double share = weighted[i] / above[i], back = y[i] * (min / above[i]) * min;
      beyond += share * share;
      slope_there += 2.0 * share * share / above[i];
      aside += back * back;
    } else {
      at_pole += y[i] * y[i];
      pole = std::fmax(pole, weighted[i]);
    }
  }
  OnQuadric<N> result;
  result.inside = within < 1.0;
  if (beyond < 1.0 && std::sqrt(at_pole) <= kDirectionLost * size) {
    result.x = y;
    result.status = Status::NotUnique;
    result.apart = std::sqrt(aside + min * min * (1.0 - beyond));
    return result;
  }
  double s = quadricStart(pole, beyond, slope_there);  // the multiplier, counted from -least^2
  for (std::size_t i = 0; i < N; ++i) s = std::fmax(s, weighted[i] - above[i]);
  for (int step = 0; step < kQuadricSteps; ++step) {
    double sum = 0.0, slope = 0.0;
    for (std::size_t i = 0; i < N; ++i) {
      if (weighted[i] == 0.0) continue;
      const double share = weighted[i] / (s + above[i]);
      sum += share * share;
      slope += share * share / (s + above[i]);
    }
    const double next = s + (sum - 1.0) / (2.0 * slope);
    if (!(next > s)) break;
    s = next;
  }
  for (std::size_t i = 0; i < N; ++i) {
    result.x[i] = weighted[i] == 0.0 ? 0.0 : semi[i] * (semi[i] * y[i] / (s + above[i]));
  }
  return result;
}

}  // namespace underact::shape
