#pragma once
#include <vector>

#include "core/identify/identified.h"

namespace underact::gui {

struct SwingPoint {
  double t_s = 0.0;
  double way_mm = 0.0;  // along the axis of W; not a number: a gap
};

/// Swings along an axis: where the target was, where the tip was, and where the body that was fitted would have been.
struct SwingPicture {
  char axis = 'x';
  std::vector<SwingPoint> target, measured, fit;
};

/// Of a measurement that is done.
SwingPicture pictureOf(const identify::AxisSwings& swings);

/// Ways in windows, with a gap after each.
std::vector<SwingPoint> pointsOf(const std::vector<identify::Window>& windows,
                                 const std::vector<std::vector<double>>& way_m);

}  // namespace underact::gui
