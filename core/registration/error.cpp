#include "core/registration/error.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/decompositions.h"

namespace underact::registration {
namespace {

/// The 5 % quantiles of chi-square for 3, 6, 9, ... 18 degrees of freedom.
constexpr std::array<double, 6> kLowTwentieth{0.351846, 1.635383, 3.325113, 5.226029, 7.260944, 9.390455};

}  // namespace

double touchingError_m(double rms_m, std::size_t marks) {
  const auto count = static_cast<double>(marks);
  return rms_m * std::sqrt(count / (count - 2.0));
}

double likelyMax_m(double rms_m, std::size_t marks) {
  const std::size_t row = std::clamp(marks, kFewestMarks, kMaxMarks) - kFewestMarks;
  const double freedom = 3.0 * static_cast<double>(row) + 3.0;
  return touchingError_m(rms_m, marks) * std::sqrt(freedom / kLowTwentieth[row]);
}

double expectedError_m(const std::vector<Vec3>& points_D, double touching_m, const Vec3& p_D) {
  const auto count = static_cast<double>(points_D.size());
  Vec3 middle_D = Vec3::Zero();
  for (const Vec3& mark_D : points_D) middle_D += mark_D / count;
  Mat3 spread = Mat3::Zero();
  for (const Vec3& mark_D : points_D) spread += (mark_D - middle_D) * (mark_D - middle_D).transpose() / count;
  const PrincipalAxes principal = principalAxes(spread);
  const Vec3 along_m2 = principal.values.cwiseMax(0.0);
  const Vec3 point = principal.axes.transpose() * (p_D - middle_D);
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double d_m2 = point.squaredNorm() - point[axis] * point[axis];
    sum += d_m2 / (along_m2.sum() - along_m2[axis]);
  }
  return touching_m * std::sqrt((1.0 + sum / 3.0) / count);
}

ErrorInTheMiddle errorInTheMiddle(const std::vector<Touch>& touches, const Fit& fit) {
  const std::vector<Vec3> points_D = referencePointsOf(touches);
  const double unit = expectedError_m(points_D, 1.0, fit.X_DW.translation());
  return {unit * touchingError_m(fit.rms_m, touches.size()), unit * likelyMax_m(fit.rms_m, touches.size())};
}

}  // namespace underact::registration
