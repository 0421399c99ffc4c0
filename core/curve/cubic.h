#pragma once
#include <array>

#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::curve {

/// A cubic Bezier curve by its four controls; parameter u in [0, 1].
using Cubic = std::array<Vec3, 4>;

/// The point at u, by de Casteljau's algorithm, which stays within the rounding of the controls.
Vec3 pointOf(const Cubic& cubic, double u) noexcept UNDERACT_REAL_TIME;

/// dp/du.
Vec3 velocityOf(const Cubic& cubic, double u) noexcept UNDERACT_REAL_TIME;

/// The two halves of a cubic, which meet in the same bits.
struct Halves {
  Cubic first;
  Cubic second;
};
/// Split at u = 0.5 by de Casteljau's steps. Not finite in, not finite out.
Halves halvesOf(const Cubic& cubic) noexcept UNDERACT_REAL_TIME;

/// Its arc length from 0 to u, by Gauss-Legendre quadrature with eight points: exact for speeds that are polynomials of
/// degree 15.
double lengthUpTo(const Cubic& cubic, double u) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::curve
