#pragma once
#include <vector>

#include "core/extremes/input.h"

namespace underact::extremes {

// What rows that ask laws and filters are fed: a signal, sample by sample.

struct Signal {
  std::vector<Vec3> e_W;
  std::vector<double> dt_s;  // before each sample
};

/// count samples at one rate from 1 Hz to 100 kHz: a walk in steps of an encoder or of any size, about zero or far from
/// it; now and then no time passes, or the rate trembles. Made from numbers that are drawn, so a kept case has few.
Signal drawSignal(Input& input, int count);

}  // namespace underact::extremes
