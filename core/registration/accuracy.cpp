#include "core/registration/accuracy.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/registration/error.h"

namespace underact::registration {
namespace {

/// A number with mean 0 and standard deviation 1: the sum of twelve uniform draws, identical on every system.
double bellDraw(std::uint64_t& random) {
  double sum = -6.0;
  for (int draw = 0; draw < 12; ++draw) sum += nextShare(random);
  return sum;
}

}  // namespace

Accuracy accuracyOf(const std::vector<Vec3>& points_D, double touching_m, int draws, std::uint64_t seed) {
  Accuracy accuracy{points_D.size(), touching_m};
  accuracy.expected_m = expectedError_m(points_D, touching_m, kMiddle_D);
  const double each_m = touching_m / std::sqrt(3.0);
  std::uint64_t random = seed;
  std::vector<double> off_m;
  double left_m2 = 0.0, seen_m2 = 0.0;
  int covered = 0;
  for (int draw = 0; draw < draws; ++draw) {
    std::vector<Touch> touches;
    for (const Vec3& mark_D : points_D) {
      Vec3 error = Vec3::Zero();
      for (int axis = 0; axis < 3; ++axis) error[axis] = each_m * bellDraw(random);
      touches.push_back({mark_D, mark_D - kMiddle_D + error, 0.0});  // stands straight: any other gives the same
    }
    const Result<Fit> fit = fitTouches(touches);
    if (!fit) continue;
    off_m.push_back((fit.value().X_DW.translation() - kMiddle_D).norm());
    left_m2 += fit.value().rms_m * fit.value().rms_m;
    seen_m2 += off_m.back() * off_m.back();
    covered += errorInTheMiddle(touches, fit.value()).likely_max_m >= accuracy.expected_m ? 1 : 0;
  }
  const auto count = static_cast<double>(std::max<std::size_t>(1, off_m.size()));
  accuracy.left_m = std::sqrt(left_m2 / count);
  accuracy.seen_m = std::sqrt(seen_m2 / count);
  accuracy.covered = covered / count;
  if (off_m.empty()) return accuracy;
  const auto rank = static_cast<std::ptrdiff_t>(0.95 * (count - 1.0));
  std::nth_element(off_m.begin(), off_m.begin() + rank, off_m.end());
  accuracy.twentieth_m = off_m[static_cast<std::size_t>(rank)];
  return accuracy;
}

}  // namespace underact::registration
