#pragma once
#include <cstdint>
#include <vector>

#include "core/base/types.h"

namespace underact::registration {

/// What registrations with so large an error of each touch come to.
struct Accuracy {
  std::size_t marks = 0;
  double touching_m = 0.0;   // root mean square distance of a touched point from its mark
  double left_m = 0.0;       // what the fits leave over (root mean square): what a person sees
  double expected_m = 0.0;   // in the middle of the workspace, by formula from touching_m
  double seen_m = 0.0;       // there, root mean square over all draws
  double twentieth_m = 0.0;  // one of twenty was farther off
  double covered = 0.0;      // share of draws whose own "19 of 20" held: it is to be 0.95
};

/// Draws so many registrations with Gaussian errors, alike in all directions, of an arm whose workspace's middle is
/// kMiddle_D, and looks how far off that middle comes to lie. The same numbers for the same seed.
Accuracy accuracyOf(const std::vector<Vec3>& marks_D, double touching_m, int draws, std::uint64_t seed);

/// The middle of the workspace 110 mm above the middle of the sheet.
inline const Vec3 kMiddle_D{0.060, 0.110, -0.040};

}  // namespace underact::registration
