#include "core/shape/point.h"

#include "core/base/translate.h"

namespace underact::shape {

Result<Point> makePoint(const Vec3& p_WC, const SourceLocation& place) {
  if (!p_WC.allFinite())
    return Problems{{phrase(TRANSLATE_NOOP("problem", "The position is not a finite point.")), place}};
  return Point{p_WC};
}

Nearest closestPoint(const Point& point, const Vec3& p_WT) noexcept {
  return {point.p_WC, Status::Unique, (p_WT - point.p_WC).norm()};
}

Point scaled(const Point& point, const Vec3& scale) {
  return {scale.cwiseProduct(point.p_WC)};
}

}  // namespace underact::shape
