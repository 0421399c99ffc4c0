#pragma once
#include <vector>

#include "core/identify/identified.h"

namespace underact::gui {

struct SwingPoint {
  double t_s = 0.0;
  double travel_mm = 0.0;  // along the axis of W; NaN for a gap
};

/// Swings along an axis: the target, the tip, and the fitted body.
struct SwingPicture {
  char axis = 'x';
  std::vector<SwingPoint> target, measured, fit;
};

/// From a completed measurement.
SwingPicture pictureOf(const identify::AxisSwings& swings);

/// The paths of all windows, with a gap after each.
std::vector<SwingPoint> pointsOf(const std::vector<identify::Window>& windows,
                                 const std::vector<std::vector<double>>& travel_m);

}  // namespace underact::gui
