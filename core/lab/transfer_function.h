#pragma once
#include <complex>
#include <vector>

#include "core/base/result.h"

namespace underact::lab {

/// A complex number, of a pole or of s, rad/s.
using Complex = std::complex<double>;

/// num(s) / den(s), coefficients in descending powers of s. Made by makeTransferFunction(), which leaves den.front()
/// not 0, a denominator of degree 1 to kHighestDegree, and a numerator of no higher degree.
struct TransferFunction {
  std::vector<double> num;  // without leading zeros; {0} is the zero function
  std::vector<double> den;
};

inline constexpr std::size_t kHighestDegree = 8;

/// Zeros in front are left out; a power of s that both have as a factor is cancelled where at least one s is left.
/// Problems: no coefficients, one that is not finite, a denominator of 0 or of a degree beyond 1 to 8, a numerator of a
/// higher degree than the denominator.
Result<TransferFunction> makeTransferFunction(std::vector<double> num, std::vector<double> den);

/// omega_n^2 / (s^2 + 2 zeta omega_n s + omega_n^2). omega_n_rad_per_s above 0, zeta from 0 on. Source: eq. B.9, C = 1.
TransferFunction secondOrder(double omega_n_rad_per_s, double zeta);

/// A coefficient list in descending powers at s. Source: Horner.
Complex valueAt(const std::vector<double>& coefficients, Complex s);

/// T(0), the value that a unit step ends at where it ends; infinite with a pole at 0. Source: eq. B.4 as errata section
/// 8 corrects it.
double gainAtRest(const TransferFunction& transfer);

/// The roots of den, rad/s, as many as its degree, repeated ones as often as they occur; conjugate pairs stand side by
/// side and are exact conjugates. Roots at 0 are exact. Simple roots are right to a few ulp of what the coefficients
/// determine; of m equal ones each is off by about the m-th root of that.
std::vector<Complex> poles(const TransferFunction& transfer);

/// What becomes of the response to a step. Settles: all poles in the left half plane. Swings: some on the imaginary
/// axis, each once (undamped). Drifts: a pole at 0, so that it goes on for ever. Grows: one in the right half plane, or
/// twice on the imaginary axis.
enum class Behaviour { Settles, Swings, Drifts, Grows };

/// A pole counts as on the axis where a change of the coefficients by a relative 1e-12 could bring it there.
Behaviour behaviourOf(const TransferFunction& transfer);

}  // namespace underact::lab
