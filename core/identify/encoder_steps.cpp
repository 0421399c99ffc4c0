#include "core/identify/encoder_steps.h"

#include <algorithm>
#include <cmath>

#include "core/base/decompositions.h"
#include "core/base/units.h"

namespace underact::identify {
namespace {

constexpr double kNoChange_rad = 1e-9;  // rounding of an angle that has not moved
constexpr std::size_t kMinChanges = 8;
constexpr double kWhole = 0.05;      // a share of the step by which a change may miss a multiple
constexpr double kMaxParts = 100.0;  // of the smallest change seen, where one step alone never came
constexpr double kStretch_s = 0.1, kMinWay_m = 0.1e-3;

/// The step nearest to guess of which all changes are multiples; none: there is no such step. Small changes first, so
/// that each refines the step before a larger one needs it.
std::optional<double> stepNear(double guess, const std::vector<double>& changes) {
  double of_both = 0.0, of_numbers = 0.0, step = guess;
  for (const double change : changes) {
    const double number = std::round(change / step);
    if (number < 1.0 || std::abs(change / step - number) > kWhole) return {};
    of_both += number * change;
    of_numbers += number * number;
    step = of_both / of_numbers;
  }
  return step;
}

/// A common divisor of all changes, by Euclid's algorithm: the remainder of a change is the next guess. None: it has
/// become too small for a step.
std::optional<double> dividerOf(const std::vector<double>& changes) {
  double guess = changes.front();
  for (std::size_t index = 0; index < changes.size();) {
    const double rest = std::abs(changes[index] - guess * std::round(changes[index] / guess));
    if (rest <= kWhole * guess) {
      ++index;
      continue;
    }
    if (rest * kMaxParts < changes.front()) return {};
    guess = rest;
    index = 0;  // those before it must be multiples of it, too
  }
  return guess;
}

/// The slope of the values over their integers, with its deviation.
Estimate sharpened(double step, std::span<const double> signal) {
  double numbers = 0.0, values = 0.0, of_numbers = 0.0, of_both = 0.0;
  const auto count = static_cast<double>(signal.size());
  const auto numberOf = [&](double value) { return std::round((value - signal[0]) / step); };
  for (const double value : signal) {
    numbers += numberOf(value) / count;
    values += value / count;
  }
  for (const double value : signal) {
    of_numbers += std::pow(numberOf(value) - numbers, 2);
    of_both += (numberOf(value) - numbers) * (value - values);
  }
  const double slope = of_both / of_numbers;
  double squares = 0.0;
  for (const double value : signal) squares += std::pow(value - values - slope * (numberOf(value) - numbers), 2);
  return {slope, std::sqrt(squares / std::max(1.0, count - 2.0) / of_numbers)};
}

}  // namespace

std::optional<Estimate> stepOf(std::span<const double> signal) {
  std::vector<double> changes;
  for (std::size_t index = 1; index < signal.size(); ++index) {
    const double change = std::abs(signal[index] - signal[index - 1]);
    if (change > kNoChange_rad) changes.push_back(change);
  }
  if (changes.size() < kMinChanges) return {};
  std::sort(changes.begin(), changes.end());
  const std::optional<double> guess = dividerOf(changes);
  const std::optional<double> step = guess ? stepNear(*guess, changes) : std::nullopt;
  if (step) return sharpened(*step, signal);
  return {};
}

std::optional<Estimate> countOf(std::span<const double> angles_rad) {
  const std::optional<Estimate> step_rad = stepOf(angles_rad);
  if (!step_rad) return {};
  const double count = 2.0 * kPi / step_rad->value;
  return Estimate{count, count * step_rad->uncertainty / step_rad->value};
}

Vec3 restNoise(std::span<const MotionRow> rows) {
  Vec3 mean_W = Vec3::Zero(), squares = Vec3::Zero();
  const double count = std::max<double>(1.0, static_cast<double>(rows.size()));
  for (const MotionRow& row : rows) mean_W += (row.p_WT - rows[0].p_WT) / count;
  for (const MotionRow& row : rows) squares += (row.p_WT - rows[0].p_WT - mean_W).cwiseAbs2() / count;
  return squares.cwiseSqrt();
}

Vec3 slowNoise(std::span<const MotionRow> rows, double period_s) {
  const auto length = static_cast<std::size_t>(std::lround(kStretch_s / period_s));
  std::vector<std::size_t> moving;  // where the stretches begin
  for (std::size_t from = 0; from + length <= rows.size(); from += length) {
    if ((rows[from + length - 1].p_WT - rows[from].p_WT).norm() >= kMinWay_m) moving.push_back(from);
  }
  const auto count = static_cast<Eigen::Index>(length), stretches = static_cast<Eigen::Index>(moving.size());
  Eigen::MatrixXd powers(count, 3), places(count, 3 * stretches);
  for (Eigen::Index row = 0; row < count; ++row) {
    const double t = 2.0 * static_cast<double>(row) / static_cast<double>(length) - 1.0;
    powers.row(row) << 1.0, t, t * t;
    for (Eigen::Index which = 0; which < stretches; ++which) {
      const std::size_t from = moving[static_cast<std::size_t>(which)];
      places.block<1, 3>(row, 3 * which) = rows[from + static_cast<std::size_t>(row)].p_WT - rows[from].p_WT;
    }
  }
  const Eigen::MatrixXd left = leastSquaresRest(powers, places);
  Vec3 squares = Vec3::Zero();
  for (Eigen::Index which = 0; which < stretches; ++which)
    squares += left.middleCols<3>(3 * which).colwise().squaredNorm().transpose();
  return (squares / (static_cast<double>(stretches) * (static_cast<double>(length) - 3.0))).cwiseSqrt();
}

}  // namespace underact::identify
