#include "core/lab/sampled_response.h"

#include <cmath>
#include <cstddef>
#include <numeric>

namespace underact::lab {
namespace {

constexpr double kNone = 1e-9;  // below this an overshoot is rounding of the mean
constexpr std::size_t kFewest = 10;
constexpr std::size_t kLastShare = 5;  // the last fifth

/// The time, in samples, at which the line between two samples passes level.
double between(const std::vector<double>& z, std::size_t before, double level) {
  return static_cast<double>(before) + (level - z[before]) / (z[before + 1] - z[before]);
}

/// The time at which z first reaches level, in samples.
std::optional<double> firstAt(const std::vector<double>& z, double level) {
  if (z.front() >= level) return 0.0;
  for (std::size_t index = 1; index < z.size(); ++index) {
    if (z[index] >= level) return between(z, index - 1, level);
  }
  return {};
}

/// The time from which z stays within the band about 1, in samples; none: it is still outside in the last fifth.
std::optional<double> settledAt(const std::vector<double>& z) {
  for (std::size_t index = z.size(); index-- > 0;) {
    if (std::abs(z[index] - 1.0) < kSettlingBand) continue;
    if (index + 1 + z.size() / kLastShare > z.size()) return {};
    return between(z, index, 1.0 + std::copysign(kSettlingBand, z[index] - 1.0));
  }
  return 0.0;
}

}  // namespace

StepMetrics metricsOf(const SampledResponse& curve) {
  StepMetrics metrics;
  if (curve.value.size() < kFewest) return metrics;
  const auto last = static_cast<std::ptrdiff_t>(curve.value.size() / kLastShare);
  const double start = curve.value.front();
  const double final_value =
      std::accumulate(curve.value.end() - last, curve.value.end(), 0.0) / static_cast<double>(last) - start;
  metrics.final_value = final_value;
  if (final_value == 0.0) return metrics;
  std::vector<double> z;
  for (const double value : curve.value) z.push_back((value - start) / final_value);
  const std::optional<double> low = firstAt(z, kRiseFrom), high = firstAt(z, kRiseTo), settled = settledAt(z);
  if (low && high) metrics.rise_10_90_s = curve.period_s * (*high - *low);
  if (settled) metrics.settling_2pct_s = curve.period_s * *settled;
  std::size_t peak = 0;
  for (std::size_t index = 0; index < z.size(); ++index) {
    if (z[index] > z[peak]) peak = index;
  }
  const bool over = z[peak] - 1.0 > kNone;
  metrics.overshoot_fraction = over ? z[peak] - 1.0 : 0.0;
  if (over) metrics.peak_time_s = curve.period_s * static_cast<double>(peak);
  return metrics;
}

}  // namespace underact::lab
