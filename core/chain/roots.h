#pragma once
#include <array>
#include <cstddef>

#include "core/base/real_time.h"

namespace underact::chain {

// Inside the room: the equations of one unknown that closed forms lead to. Everything on the stack; no complex numbers.

/// c[0] + c[1] t + c[2] t^2.
using Quadratic = std::array<double, 3>;
/// Coefficients up to t^4.
using Quartic = std::array<double, 5>;

/// factor a b, coefficient by coefficient.
Quartic product(const Quadratic& a, const Quadratic& b, double factor) noexcept UNDERACT_REAL_TIME;
/// a + b, coefficient by coefficient.
Quartic sum(const Quartic& a, const Quartic& b) noexcept UNDERACT_REAL_TIME;

/// Real roots, in growing order; where two lie within rounding of each other, there is one between them.
struct Roots {
  std::array<double, 4> all{};
  std::size_t count = 0;
};

/// All real roots in [low, high] of a polynomial of degree 4 or less, isolated between the zeros of its derivatives, so
/// that none is missed. One that only touches zero, to 1e-13 of its largest term or 2^-48 of its largest coefficient,
/// counts. None of a polynomial without a coefficient, or of one that is not finite. Within the rounding of the
/// coefficients. Cost: at most 10 searches of some 60 evaluations. Source: Collins and Loos 1976, "Polynomial real root
/// isolation by differentiation".
Roots rootsWithin(const Quartic& c, double low, double high) noexcept UNDERACT_REAL_TIME;

/// All real roots, wherever they are.
Roots rootsOf(const Quartic& c) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::chain
