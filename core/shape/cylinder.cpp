#include "core/shape/cylinder.h"

#include <cmath>

#include "core/base/translate.h"
#include "core/shape/direction.h"

namespace underact::shape {

Result<Cylinder> makeCylinder(const Vec3& p_WC, const Vec3& axis_W, double radius_m, const SourceLocation& place) {
  Problems problems;
  const std::optional<Vec3> unit_W = unitOf(axis_W);
  if (!p_WC.allFinite())
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "The point on the axis is not a finite point.")), place});
  if (!unit_W) problems.push_back({phrase(TRANSLATE_NOOP("problem", "The axis has no direction.")), place});
  if (!(radius_m > 0.0 && std::isfinite(radius_m)))
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "The radius must be above 0.")), place});
  if (!problems.empty()) return problems;
  return Cylinder{p_WC, *unit_W, radius_m};
}

Nearest closestPoint(const Cylinder& cylinder, const Vec3& p_WT) noexcept {
  const Vec3 p_CT_W = p_WT - cylinder.p_WC;
  const double along_m = p_CT_W.dot(cylinder.axis_W);
  Vec3 radial_W = p_CT_W - along_m * cylinder.axis_W;           // eq. 4.25, seen from C
  radial_W -= radial_W.dot(cylinder.axis_W) * cylinder.axis_W;  // again, as on the circle
  const double off_axis_m = radial_W.norm();
  const double height_m = off_axis_m - cylinder.radius_m;
  if (isOnAxis(off_axis_m, cylinder.p_WC, p_WT)) {
    return {p_WT, Status::NotUnique, height_m};
  }
  const Vec3 p_WP =
      cylinder.p_WC + along_m * cylinder.axis_W + cylinder.radius_m * (radial_W / off_axis_m);  // eq. 4.26
  return {p_WP, Status::Unique, height_m};
}

}  // namespace underact::shape
