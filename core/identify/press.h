#pragma once
#include <optional>
#include <span>

#include "core/base/result.h"
#include "core/identify/estimate.h"
#include "core/identify/swing.h"

namespace underact::identify {

/// A slow press away from the target and back: force against displacement.
struct Press {
  Estimate stiffness_N_per_m;               // mean of both ways
  double down_N_per_m = 0.0;                // on the way there ...
  double up_N_per_m = 0.0;                  // ... and back
  double hysteresis_N = 0.0;                // force there less force back, at the middle of the way
  double residual_N = 0.0;                  // root mean square about the two lines
  double linear_m = 0.0;                    // as far as nothing was cut
  std::optional<double> clamped_at_m = {};  // the way from which on the gate cut; none: it never did
  double max_N = 0.0;                       // sent at most
};

/// along_W: of the press, length 1. Problems: it was not pressed, or only one way.
Result<Press> pressOf(std::span<const MotionRow> rows, const Vec3& along_W, double period_s);

}  // namespace underact::identify
