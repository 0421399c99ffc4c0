#pragma once
#include <functional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/identify/body.h"
#include "core/identify/swing.h"

namespace underact::identify {

/// The body whose motion fits the windows best, under the force that was sent.
struct BodyFit {
  Body body;
  Body uncertainty;                           // one standard deviation each
  double residual_m = 0.0;                    // root mean square
  std::vector<std::vector<double>> travel_m;  // of the body, window by window
  int rounds = 0;
};

/// Least squares of the displacement (an output error: the force is known, the samples are noisy) over mass, friction,
/// damping and bias, which all windows share, and over the position and velocity at the start of each window. Levenberg
/// and Marquardt, each window's own two unknowns eliminated. The uncertainty is the larger of that from the residual
/// and that by the jackknife over swings, which accounts for correlated residuals. Problems: too
/// little motion; no convergence; stopped. stop: asked for each window, true ends the fit; may be empty.
Result<BodyFit> fitBody(std::span<const Window> windows, const std::function<bool()>& stop = {});

}  // namespace underact::identify
