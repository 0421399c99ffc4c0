#include "app/gui/model/spectrum.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <cstddef>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr std::size_t kMin = 16, kMax = 4096;

double meanOf(std::span<const float> values) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const float value : values) {
    if (!std::isfinite(value)) continue;
    sum += static_cast<double>(value);
    ++count;
  }
  return count == 0 ? 0.0 : sum / static_cast<double>(count);
}

}  // namespace

std::vector<SpectrumLine> spectrumOf(std::span<const float> values, double rate_hz) {
  if (values.size() < kMin) return {};
  const std::size_t size = std::min(std::bit_floor(values.size()), kMax);
  const double mean = meanOf(values);
  std::vector<double> window(size), power(size / 2 + 1, 0.0);
  for (std::size_t at = 0; at < size; ++at)
    window[at] = 0.5 - 0.5 * std::cos(2.0 * kPi * static_cast<double>(at) / static_cast<double>(size));
  std::size_t windows = 0;
  Eigen::FFT<double> fourier;
  std::vector<double> part(size);
  std::vector<std::complex<double>> lines;
  for (std::size_t begin = 0; begin + size <= values.size(); begin += size / 2, ++windows) {
    for (std::size_t at = 0; at < size; ++at) {
      const auto value = static_cast<double>(values[begin + at]);
      part[at] = std::isfinite(value) ? window[at] * (value - mean) : 0.0;
    }
    fourier.fwd(lines, part);
    for (std::size_t line = 0; line < power.size(); ++line) power[line] += std::norm(lines[line]);
  }
  std::vector<SpectrumLine> spectrum(power.size());
  const double to_amplitude = 4.0 / static_cast<double>(size);  // two sides, and the mean of 1/2 of a Hann window
  for (std::size_t line = 0; line < spectrum.size(); ++line) {
    spectrum[line].frequency_hz = rate_hz * static_cast<double>(line) / static_cast<double>(size);
    spectrum[line].amplitude = to_amplitude * std::sqrt(power[line] / static_cast<double>(windows));
  }
  return spectrum;
}

}  // namespace underact::gui
