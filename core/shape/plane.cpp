#include "core/shape/plane.h"

#include "core/base/translate.h"
#include "core/shape/direction.h"

namespace underact::shape {

Result<Plane> makePlane(const Vec3& p_WC, const Vec3& normal_W, const SourceLocation& place) {
  Problems problems;
  const std::optional<Vec3> unit_W = unitOf(normal_W);
  if (!p_WC.allFinite())
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "The point is not a finite point.")), place});
  if (!unit_W) problems.push_back({phrase(TRANSLATE_NOOP("problem", "The normal has no direction.")), place});
  if (!problems.empty()) return problems;
  return Plane{p_WC, *unit_W};
}

Nearest closestPoint(const Plane& plane, const Vec3& p_WT) noexcept {
  const double height_m = (p_WT - plane.p_WC).dot(plane.normal_W);  // eq. 4.12, signed
  return {p_WT - height_m * plane.normal_W, Status::Unique, height_m};
}

Plane scaled(const Plane& plane, const Vec3& scale) {
  return {scale.cwiseProduct(plane.p_WC), plane.normal_W.cwiseQuotient(scale).normalized()};
}

}  // namespace underact::shape
