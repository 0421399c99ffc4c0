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

/// Leading zeros are left out; a power of s common to both is cancelled while at least one s remains. Problems: no
/// coefficients, one that is not finite, a denominator of 0 or of a degree outside 1 to 8, a numerator of a higher
/// degree than the denominator.
Result<TransferFunction> makeTransferFunction(std::vector<double> num, std::vector<double> den);

/// omega_n^2 / (s^2 + 2 zeta omega_n s + omega_n^2). omega_n_rad_per_s above 0, zeta from 0 on. Source: eq. B.9, C = 1.
TransferFunction secondOrder(double omega_n_rad_per_s, double zeta);

/// A coefficient list in descending powers at s. Source: Horner.
Complex valueAt(const std::vector<double>& coefficients, Complex s);

/// T(0), the final value of a unit step where it has one; infinite with a pole at 0. Source: eq. B.4 as errata section
/// 8 corrects it.
double gainAtRest(const TransferFunction& transfer);

/// The roots of den, rad/s, as many as its degree, with multiplicity; conjugate pairs are adjacent and exact
/// conjugates. Roots at 0 are exact. Simple roots are right to a few ulp of what the coefficients determine; each of m
/// equal ones is off by about the m-th root of that.
std::vector<Complex> poles(const TransferFunction& transfer);

/// How the response to a step ends. Settles: all poles in the left half plane. Swings: simple poles on the imaginary
/// axis (undamped). Drifts: a pole at 0, so that it does not end. Grows: a pole in the right half plane, or a double
/// one on the imaginary axis.
enum class Behaviour { Settles, Swings, Drifts, Grows };

/// A pole counts as on the axis where a change of the coefficients by a relative 1e-12 could bring it there.
Behaviour behaviourOf(const TransferFunction& transfer);

}  // namespace underact::lab
