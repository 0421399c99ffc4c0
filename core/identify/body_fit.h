#pragma once
#include <functional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/identify/body.h"
#include "core/identify/swing.h"

namespace underact::identify {

/// A body that moves as the windows show, under the force that was sent.
struct BodyFit {
  Body body;
  Body uncertainty;                        // one standard deviation each
  double residual_m = 0.0;                 // root mean square
  std::vector<std::vector<double>> way_m;  // of the body, window by window
  int rounds = 0;
};

/// Least squares of the way (an output error: the force is known, the samples are not) over mass, friction, damping and
/// bias, which all windows share, and over the place and the velocity with which each begins. Levenberg and Marquardt,
/// each window's own two unknowns eliminated. The uncertainty is the larger one of that from the residual, and of that
/// from how windows differ (each a cluster), which counts residuals that hang together. Problems: too little motion to
/// begin with; it does not come to an end; it was stopped. stop: asked window by window, true ends it early; may be
/// empty.
Result<BodyFit> fitBody(std::span<const Window> windows, const std::function<bool()>& stop = {});

}  // namespace underact::identify
