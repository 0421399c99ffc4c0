#include "core/lab/unit_step.h"

#include <algorithm>
#include <cmath>

#include "core/base/trig.h"

namespace underact::lab {
namespace {

using Matrix = UnitStep::Matrix;
using Vector = UnitStep::Vector;

constexpr double kSmall = 0.5;  // up to here the series below is exact to the last bit
constexpr int kTerms = 16;      // 0.5^17 / 17! is 2e-20

Complex exponential(const Complex& z) {
  const SinCos turn = sinCos(z.imag());
  const double size = std::exp(z.real());
  return {size * turn.cos, size * turn.sin};
}

/// (e^a - e^b) / (a - b); e^a where they are equal.
Complex slopeOfExponential(const Complex& a, const Complex& b) {
  if (std::abs(a - b) > 1.0) return (exponential(a) - exponential(b)) / (a - b);
  const Complex half = 0.5 * (a - b), square = half * half;
  Complex series = 1.0, term = 1.0;  // sinh(half) / half
  for (int n = 1; n <= 8; ++n) {
    term *= square / static_cast<double>(2 * n * (2 * n + 1));
    series += term;
  }
  return exponential(0.5 * (a + b)) * series;
}

/// e^(J t) of a lower bidiagonal J: the series of a 2^n-th of t, squared n times. The diagonal and the one below, known
/// in closed form, are inserted at each squaring; otherwise the error would double each time. Source: Higham 2008,
/// Functions of Matrices, section 10.3.
Matrix exponential(const Vector& diagonal, const Vector& below, double t_s) {
  const Eigen::Index size = diagonal.size();
  const double largest = diagonal.cwiseAbs().maxCoeff() + (size > 1 ? below.cwiseAbs().maxCoeff() : 0.0);
  int halvings = 0;
  for (double norm = largest * t_s; norm > kSmall && halvings < 1100; norm *= 0.5) ++halvings;
  double part_s = std::ldexp(t_s, -halvings);
  Matrix J = Matrix::Zero(size, size);
  J.diagonal() = part_s * diagonal;
  if (size > 1) J.diagonal(-1) = part_s * below;
  Matrix result = Matrix::Identity(size, size);
  for (int n = kTerms; n > 0; --n) {
    result = J.lazyProduct(result).eval() / static_cast<double>(n);
    result.diagonal().array() += 1.0;
  }
  for (int n = 0; n < halvings; ++n) {
    result = result.lazyProduct(result).eval();
    part_s *= 2.0;
    for (Eigen::Index row = 0; row < size; ++row) {
      result(row, row) = exponential(part_s * diagonal[row]);
      if (row > 0)
        result(row, row - 1) =
            part_s * below[row - 1] * slopeOfExponential(part_s * diagonal[row], part_s * diagonal[row - 1]);
    }
  }
  return result;
}

/// Divides a polynomial (descending powers) by s - root; gives the remainder.
Complex divide(std::vector<Complex>& coefficients, const Complex& root) {
  for (std::size_t index = 1; index < coefficients.size(); ++index)
    coefficients[index] += root * coefficients[index - 1];
  const Complex remainder = coefficients.back();
  coefficients.pop_back();
  return remainder;
}

}  // namespace

UnitStep::UnitStep(const TransferFunction& transfer) {
  std::vector<Complex> roots = poles(transfer);
  // Slow ones last, so that no stage follows one that is much slower; pairs stay together.
  std::stable_sort(roots.begin(), roots.end(),
                   [](const Complex& a, const Complex& b) { return std::abs(a) > std::abs(b); });
  const auto size = static_cast<Eigen::Index>(roots.size());
  poles_ = Eigen::Map<const Vector>(roots.data(), size);
  gains_ = poles_.unaryExpr([](const Complex& pole) { return pole == 0.0 ? Complex(1.0) : -pole; });
  const double lead = transfer.den.front();
  if (transfer.num.size() == transfer.den.size()) direct_ = transfer.num.front() / lead;
  // num / den as a sum of the outputs of the stages: the remainders of num by one pole after the other, the last first.
  std::vector<Complex> num(transfer.num.begin(), transfer.num.end());
  output_ = Row::Zero(size);
  for (Eigen::Index stage = size - 1; stage >= 0 && !num.empty(); --stage)
    output_[stage] = divide(num, poles_[stage]) / lead / gains_.head(stage + 1).prod();
  // dy/dt = C J (1 - stages) = -C J stages, where 1 is at rest: the row's J, pole on the diagonal, gain below.
  rate_output_ = -output_.cwiseProduct(poles_.transpose());
  for (Eigen::Index stage = 1; stage < size; ++stage) rate_output_[stage - 1] -= output_[stage] * gains_[stage];
}

double UnitStep::at(double t_s) const {
  const Eigen::Index size = poles_.size();
  Vector diagonal = Vector::Zero(size + 1);  // the step itself comes first, as a stage that keeps its 1
  diagonal.tail(size) = poles_;
  return direct_ + output_.transpose().cwiseProduct(exponential(diagonal, gains_, t_s).col(0).tail(size)).sum().real();
}

Matrix UnitStep::stagesAfter(double t_s) const {
  return exponential(poles_, gains_.tail(poles_.size() - 1), t_s);
}

}  // namespace underact::lab
