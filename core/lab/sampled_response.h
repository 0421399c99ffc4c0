#pragma once
#include <vector>

#include "core/lab/step_metrics.h"

namespace underact::lab {

/// A sampled response: values at 0, period_s, 2 period_s, ... from the step on; the first is the value before it.
struct SampledResponse {
  double period_s = 1e-3;
  std::vector<double> value;
};

/// The metrics of a transfer function, from samples, interpolated linearly. The final value is the mean of the
/// last fifth; where that fifth leaves the band of 2 % about it, nothing settles, as with an undamped response. Values
/// are relative to the first one. No motion, or fewer than ten samples: only a final value, or none.
StepMetrics metricsOf(const SampledResponse& curve);

}  // namespace underact::lab
