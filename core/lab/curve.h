#pragma once
#include <vector>

#include "core/lab/step_metrics.h"

namespace underact::lab {

/// A response as samples tell it: at 0, period_s, 2 period_s, ... from the step on; the first is where it starts from.
struct Curve {
  double period_s = 1e-3;
  std::vector<double> value;
};

/// The same metrics as of a transfer function, from samples: times between two samples on the line through them. The
/// final value is the mean of the last fifth; where that fifth still leaves the band of 2 % about it, nothing settles,
/// as of a response that swings. value: less its first one. Not moved at all, or fewer than ten samples: only a final
/// value, or none.
StepMetrics metricsOf(const Curve& curve);

}  // namespace underact::lab
