#pragma once
#include <cstdint>
#include <vector>

#include "core/base/types.h"

namespace underact::registration {

/// The accuracy of registrations with a given error of each touch.
struct Accuracy {
  std::size_t marks = 0;
  double touching_m = 0.0;   // root mean square distance of a touched point from its reference point
  double left_m = 0.0;       // residual of the fits (root mean square): what a person sees
  double expected_m = 0.0;   // in the middle of the workspace, by formula from touching_m
  double seen_m = 0.0;       // at the same point, root mean square over all draws
  double twentieth_m = 0.0;  // 95th percentile
  double covered = 0.0;      // share of draws whose own "19 of 20" bound held: 0.95 is expected
};

/// Simulates registrations with isotropic Gaussian errors, of an arm whose workspace has its middle at kMiddle_D, and
/// measures the error there. The same numbers for the same seed.
Accuracy accuracyOf(const std::vector<Vec3>& points_D, double touching_m, int draws, std::uint64_t seed);

/// The middle of the workspace 110 mm above the middle of the sheet.
inline const Vec3 kMiddle_D{0.060, 0.110, -0.040};

}  // namespace underact::registration
