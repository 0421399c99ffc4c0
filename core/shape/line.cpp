#include "core/shape/line.h"

#include "core/base/translate.h"
#include "core/shape/direction.h"

namespace underact::shape {

Result<Line> makeLine(const Vec3& p_WC, const Vec3& direction_W, const SourceLocation& place) {
  Problems problems;
  const std::optional<Vec3> axis_W = unitOf(direction_W);
  if (!p_WC.allFinite())
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "The point is not a finite point.")), place});
  if (!axis_W) problems.push_back({phrase(TRANSLATE_NOOP("problem", "The line has no direction.")), place});
  if (!problems.empty()) return problems;
  return Line{p_WC, *axis_W};
}

Nearest closestPoint(const Line& line, const Vec3& p_WT) noexcept {
  const Vec3 p_WP = line.p_WC + (p_WT - line.p_WC).dot(line.axis_W) * line.axis_W;  // eq. 4.9, erratum 4.7-4.9
  return {p_WP, Status::Unique, (p_WT - p_WP).norm()};
}

Line scaled(const Line& line, const Vec3& scale) {
  return {scale.cwiseProduct(line.p_WC), scale.cwiseProduct(line.axis_W).normalized()};
}

}  // namespace underact::shape
