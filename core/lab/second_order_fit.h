#pragma once
#include <optional>

#include "core/lab/sampled_response.h"

namespace underact::lab {

/// y(t) of C omega_n^2 / (s^2 + 2 zeta omega_n s + omega_n^2) under a unit step, C = 1; zeta from 0 on. Source: eq.
/// B.9.
double secondOrderAt(double omega_n_rad_per_s, double zeta, double t_s) noexcept;

/// The second-order response nearest to a curve.
struct SecondOrderFit {
  double omega_n_rad_per_s = 0.0;
  double zeta = 0.0;
  double gain = 0.0;      // C: where it ends, in the curve's unit
  double residual = 0.0;  // root of the mean square of what is left, in the curve's unit
};

/// Least squares over all samples, starting from the best of a grid of frequencies and dampings. None: fewer than ten
/// samples, or the curve does not leave its first value. Frequencies from a quarter period in the whole curve to half a
/// period in a sample, dampings from 1e-4 to 50.
std::optional<SecondOrderFit> fitSecondOrder(const SampledResponse& curve);

}  // namespace underact::lab
