#pragma once
#include <span>
#include <vector>

namespace underact::gui {

struct SpectrumLine {
  double frequency_hz = 0.0;
  double amplitude = 0.0;  // in the unit of the values
};

/// How large which frequencies are, 0 to half the rate: a sine of amplitude A that goes on for all the time stands at
/// its frequency with A. Hann windows of up to 4096 values that overlap by half; the mean power of all of them (Welch
/// 1967). What is constant is taken off; a value that is not finite counts as the mean. Empty: fewer than 16 values.
std::vector<SpectrumLine> spectrumOf(std::span<const float> values, double rate_hz);

}  // namespace underact::gui
