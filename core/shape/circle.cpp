#include "core/shape/circle.h"

#include <cmath>

#include "core/base/translate.h"
#include "core/shape/direction.h"

namespace underact::shape {

Result<Circle> makeCircle(const Vec3& p_WC, const Vec3& normal_W, double radius_m, const SourceLocation& place) {
  Problems problems;
  const std::optional<Vec3> axis_W = unitOf(normal_W);
  if (!p_WC.allFinite())
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "The centre is not a finite point.")), place});
  if (!axis_W) problems.push_back({phrase(TRANSLATE_NOOP("problem", "The axis has no direction.")), place});
  if (!(radius_m > 0.0 && std::isfinite(radius_m)))
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "The radius must be above 0.")), place});
  if (!problems.empty()) return problems;
  return Circle{p_WC, *axis_W, radius_m};
}

Nearest closestPoint(const Circle& circle, const Vec3& p_WT) noexcept {
  const Vec3 p_CT_W = p_WT - circle.p_WC;
  const double along_m = p_CT_W.dot(circle.axis_W);
  Vec3 radial_W = p_CT_W - along_m * circle.axis_W;  // eq. 4.19, seen from C
  // Projected again: near the axis the first projection leaves an error along the axis as large as radial_W itself.
  radial_W -= radial_W.dot(circle.axis_W) * circle.axis_W;
  const double off_axis_m = radial_W.norm();
  const double from_rim_m = off_axis_m - circle.radius_m;
  const double distance_m = std::sqrt(along_m * along_m + from_rim_m * from_rim_m);
  if (isOnAxis(off_axis_m, circle.p_WC, p_WT)) {
    return {p_WT, Status::NotUnique, distance_m};
  }
  const Vec3 p_WP = circle.p_WC + circle.radius_m * (radial_W / off_axis_m);  // eq. 4.20, erratum 4.20
  return {p_WP, Status::Unique, distance_m};
}

}  // namespace underact::shape
