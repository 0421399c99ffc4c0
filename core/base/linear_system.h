#pragma once
#include <array>
#include <cstddef>

#include "core/base/real_time.h"

namespace underact {

/// A symmetric system a x = b of up to N unknowns, its lower half, on the stack. Eigen's own decompositions may
/// allocate, as far as clang can see. Elements beyond size are not read, and not initialised.
template <std::size_t N>
struct SymmetricSystem {
  std::array<std::array<double, N>, N> a;
  std::array<double, N> b;
  std::size_t size = 0;
};

/// b := a^-1 b, by LDL^T; a is overwritten. False where a pivot is not above 0: a is not positive definite to within
/// rounding. Cost: size^3 / 6 multiplications. Source: Golub and Van Loan, Matrix Computations, 4.1.
template <std::size_t N>
bool solveInPlace(SymmetricSystem<N>& s) noexcept UNDERACT_REAL_TIME {
  for (std::size_t j = 0; j < s.size; ++j) {
    double pivot = s.a[j][j];
    for (std::size_t k = 0; k < j; ++k) pivot -= s.a[j][k] * s.a[j][k] * s.a[k][k];
    if (!(pivot > 0.0)) return false;
    s.a[j][j] = pivot;
    for (std::size_t i = j + 1; i < s.size; ++i) {
      double sum = s.a[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= s.a[i][k] * s.a[j][k] * s.a[k][k];
      s.a[i][j] = sum / pivot;
    }
  }
  for (std::size_t i = 0; i < s.size; ++i) {
    for (std::size_t k = 0; k < i; ++k) s.b[i] -= s.a[i][k] * s.b[k];
  }
  for (std::size_t i = s.size; i-- > 0;) {
    s.b[i] /= s.a[i][i];
    for (std::size_t k = i + 1; k < s.size; ++k) s.b[i] -= s.a[k][i] * s.b[k];
  }
  return true;
}

}  // namespace underact
