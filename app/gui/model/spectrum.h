#pragma once
#include <span>
#include <vector>

namespace underact::gui {

struct SpectrumLine {
  double frequency_hz = 0.0;
  double amplitude = 0.0;  // in the unit of the values
};

/// The amplitude spectrum, 0 to half the rate: a steady sine of amplitude A appears at its frequency with A. Hann
/// windows of up to 4096 values that overlap by half; the mean power of all of them (Welch 1967). The mean is
/// subtracted; a value that is not finite counts as the mean. Empty: fewer than 16 values.
std::vector<SpectrumLine> spectrumOf(std::span<const float> values, double rate_hz);

}  // namespace underact::gui
