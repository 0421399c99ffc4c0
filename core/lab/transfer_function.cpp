#include "core/lab/transfer_function.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/decompositions.h"
#include "core/base/translate.h"

namespace underact::lab {
namespace {

constexpr double kOnTheAxis = 1e-12;      // relative, of the coefficients, which are typed with about as many digits
constexpr double kTwiceOnTheAxis = 1e-6;  // its square root: the distance of the two parts of a double root
constexpr int kPolishes = 12;

void dropLeadingZeros(std::vector<double>& coefficients) {
  const auto first = std::find_if(coefficients.begin(), coefficients.end(), [](double one) { return one != 0.0; });
  coefficients.erase(coefficients.begin(), first);
}

std::size_t trailingZeros(const std::vector<double>& coefficients) {
  std::size_t count = 0;
  while (count < coefficients.size() && coefficients[coefficients.size() - 1 - count] == 0.0) ++count;
  return count;
}

bool allFinite(const std::vector<double>& coefficients) {
  return std::all_of(coefficients.begin(), coefficients.end(), [](double one) { return std::isfinite(one); });
}

/// The sum of |a_i| |s|^i, to which the rounding of valueAt() is proportional.
double sizeAt(const std::vector<double>& coefficients, double size) {
  double sum = 0.0;
  for (const double one : coefficients) sum = sum * size + std::abs(one);
  return sum;
}

std::vector<double> derivative(const std::vector<double>& coefficients) {
  std::vector<double> result;
  for (std::size_t index = 0; index + 1 < coefficients.size(); ++index)
    result.push_back(coefficients[index] * static_cast<double>(coefficients.size() - 1 - index));
  return result;
}

/// The Ehrlich-Aberth iteration, on all roots at a time, so that none is found twice; it ends where the value at a root
/// is within its rounding.
void polish(const std::vector<double>& monic, std::vector<Complex>& roots) {
  const std::vector<double> slope = derivative(monic);
  for (int step = 0; step < kPolishes; ++step) {
    for (Complex& root : roots) {
      const Complex value = valueAt(monic, root);
      if (std::abs(value) <= 0x1p-53 * sizeAt(monic, std::abs(root))) continue;
      const Complex newton = value / valueAt(slope, root);
      Complex others = 0.0;
      for (const Complex& other : roots) {
        if (other != root) others += 1.0 / (root - other);
      }
      const Complex loop = newton / (1.0 - newton * others);
      if (std::isfinite(loop.real()) && std::isfinite(loop.imag())) root -= loop;
    }
  }
}

/// Makes real roots real and the others exact adjacent pairs: each takes the partner nearest to its conjugate.
std::vector<Complex> paired(std::vector<Complex> roots) {
  std::vector<Complex> result;
  while (!roots.empty()) {
    const Complex root = roots.back();
    roots.pop_back();
    const auto mirror = std::min_element(roots.begin(), roots.end(), [&](const Complex& a, const Complex& b) {
      return std::abs(a - std::conj(root)) < std::abs(b - std::conj(root));
    });
    if (mirror == roots.end() || std::abs(*mirror - std::conj(root)) >= 2.0 * std::abs(root.imag())) {
      result.emplace_back(root.real(), 0.0);
      continue;
    }
    const Complex mean = 0.5 * (root + std::conj(*mirror));
    roots.erase(mirror);
    result.emplace_back(mean.real(), std::abs(mean.imag()));
    result.push_back(std::conj(result.back()));
  }
  return result;
}

bool liesOn(const std::vector<double>& coefficients, double omega, double share) {
  return std::abs(valueAt(coefficients, {0.0, omega})) <= share * sizeAt(coefficients, omega);
}

}  // namespace

Result<TransferFunction> makeTransferFunction(std::vector<double> num, std::vector<double> den) {
  Problems problems;
  if (num.empty())
    problems.push_back(
        {phrase(TRANSLATE_NOOP("problem", "The numerator has no coefficients; for the number 1, write 1."))});
  if (!allFinite(num))
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "A coefficient of the numerator is not a finite number."))});
  if (!allFinite(den))
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "A coefficient of the denominator is not a finite number."))});
  dropLeadingZeros(num);
  dropLeadingZeros(den);
  const std::string room = std::to_string(kHighestDegree);
  if (den.size() < 2)
    problems.push_back({phrase(TRANSLATE_NOOP(
        "problem", "The denominator has no s; give at least two coefficients, such as 1,1 for s + 1."))});
  if (den.size() > kHighestDegree + 1)
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "The denominator is of order %1; at most %2 is possible."),
                               {std::to_string(den.size() - 1), room})});
  if (den.size() >= 2 && num.size() > den.size())
    problems.push_back(
        {phrase(TRANSLATE_NOOP("problem",
                               "The numerator is of a higher order than the denominator (%1 against %2), "
                               "so a step would give an impulse. Lower its order."),
                {std::to_string(num.size() - 1), std::to_string(den.size() - 1)})});
  if (!problems.empty()) return problems;
  if (num.empty()) num = {0.0};
  std::size_t common = std::min(trailingZeros(den), trailingZeros(num));
  common = std::min(common, den.size() - 2);
  den.resize(den.size() - common);
  num.resize(std::max<std::size_t>(num.size(), common + 1) - common);
  return TransferFunction{std::move(num), std::move(den)};
}

TransferFunction secondOrder(double omega_n_rad_per_s, double zeta) {
  const double square = omega_n_rad_per_s * omega_n_rad_per_s;
  return {{square}, {1.0, 2.0 * zeta * omega_n_rad_per_s, square}};
}

Complex valueAt(const std::vector<double>& coefficients, Complex s) {
  Complex value = 0.0;
  for (const double one : coefficients) value = value * s + one;
  return value;
}

double gainAtRest(const TransferFunction& transfer) {
  return transfer.num.back() / transfer.den.back();
}

std::vector<Complex> poles(const TransferFunction& transfer) {
  std::vector<double> monic = transfer.den;
  const std::size_t at_zero = trailingZeros(monic);
  monic.resize(monic.size() - at_zero);
  std::vector<Complex> roots;
  if (const std::size_t degree = monic.size() - 1; degree > 0) {
    const double lead = monic.front();
    for (double& one : monic) one /= lead;
    // In a unit of time in which the product of the roots is about 1; a power of two, to avoid rounding.
    const double unit = std::exp2(std::round(std::log2(std::abs(monic.back())) / static_cast<double>(degree)));
    double power = 1.0;
    for (double& one : monic) {
      one /= power;
      power *= unit;
    }
    const auto size = static_cast<Eigen::Index>(degree);
    Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(size, size);
    companion.diagonal(-1).setOnes();
    for (Eigen::Index row = 0; row < size; ++row)
      companion(row, size - 1) = -monic[degree - static_cast<std::size_t>(row)];
    const Eigen::VectorXcd found = eigenvaluesOf(companion);
    roots.assign(found.begin(), found.end());
    polish(monic, roots);
    for (Complex& root : roots) root *= unit;
  }
  std::vector<Complex> all = paired(std::move(roots));
  all.insert(all.end(), at_zero, Complex(0.0, 0.0));
  return all;
}

Behaviour behaviourOf(const TransferFunction& transfer) {
  const std::vector<double> slope = derivative(transfer.den);
  Behaviour behaviour = Behaviour::Settles;
  for (const Complex& pole : poles(transfer)) {
    const double omega = std::abs(pole.imag());
    if (!liesOn(transfer.den, omega, kOnTheAxis)) {
      if (pole.real() > 0.0) return Behaviour::Grows;
      continue;
    }
    if (liesOn(slope, omega, kTwiceOnTheAxis)) return Behaviour::Grows;
    if (omega == 0.0)
      behaviour = Behaviour::Drifts;
    else if (behaviour == Behaviour::Settles)
      behaviour = Behaviour::Swings;
  }
  return behaviour;
}

}  // namespace underact::lab
