#include "core/arm/planar.h"

#include <algorithm>
#include <cmath>

#include "core/arm/branches.h"

namespace underact::arm {
namespace {

/// sqrt(x^2 + y^2) without overflow; not std::hypot, whose last bit depends on the library, as replays must not.
double lengthOf(double x, double y) noexcept UNDERACT_REAL_TIME {
  const double larger = std::max(std::abs(x), std::abs(y));
  if (!(larger > 0.0)) return 0.0;
  const double u = x / larger, v = y / larger;
  return larger * std::sqrt(u * u + v * v);
}

}  // namespace

PlanarReach planarReach(const Geometry& geometry, const Vec3& p_WT) noexcept {
  const Vec3 p_BT_W = p_WT - geometry.p_WB;
  PlanarReach result;
  result.x_m = p_BT_W.z(), result.y_m = p_BT_W.x(), result.z_m = p_BT_W.y();  // in B, eq. 3.1
  const double upper = geometry.upper_m, fore = geometry.fore_m;
  result.elbow_sin =
      (result.x_m * result.x_m + result.y_m * result.y_m + result.z_m * result.z_m - upper * upper - fore * fore) /
      (2.0 * upper * fore);  // erratum 3.13
  const double s3 = std::clamp(result.elbow_sin, -1.0, 1.0);
  result.elbow = {s3, std::sqrt((1.0 - s3) * (1.0 + s3))};
  result.off_axis_m = lengthOf(result.x_m, result.y_m);
  const double outer_m = upper + fore, inner_m = std::abs(upper - fore);
  const double away_m = lengthOf(result.off_axis_m, result.z_m);
  result.reachable = away_m <= (1.0 + kOnBoundary) * outer_m && away_m >= inner_m - kOnBoundary * outer_m;
  return result;
}

SinCos scaledThigh(const Geometry& geometry, const PlanarReach& reach, double elbow) noexcept {
  const double b = geometry.upper_m + geometry.fore_m * reach.elbow.sin;  // erratum 3.14
  const double c = geometry.fore_m * elbow * reach.elbow.cos;
  return {c * reach.off_axis_m + b * reach.z_m, b * reach.off_axis_m - c * reach.z_m};  // eq. 3.16
}

Thigh thighOf(const Geometry& geometry, const PlanarReach& reach, double elbow) noexcept {
  const SinCos scaled = scaledThigh(geometry, reach, elbow);
  const double length = lengthOf(scaled.sin, scaled.cos);
  Thigh result;
  if (length > 0.0) result.thigh = {scaled.sin / length, scaled.cos / length};
  const SinCos& q2 = result.thigh;
  const double c3 = elbow * reach.elbow.cos, s3 = reach.elbow.sin;
  result.shin = {q2.sin * c3 + q2.cos * s3, q2.cos * c3 - q2.sin * s3};
  return result;
}

}  // namespace underact::arm
