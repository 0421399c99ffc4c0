#include "core/shape/sphere.h"

#include <cmath>

#include "core/base/translate.h"

namespace underact::shape {

Result<Sphere> makeSphere(const Vec3& p_WC, double radius_m, const SourceLocation& place) {
  Problems problems;
  if (!p_WC.allFinite())
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "The centre is not a finite point.")), place});
  if (!(radius_m > 0.0 && std::isfinite(radius_m)))
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "The radius must be above 0.")), place});
  if (!problems.empty()) return problems;
  return Sphere{p_WC, radius_m};
}

Nearest closestPoint(const Sphere& sphere, const Vec3& p_WT) noexcept {
  const Vec3 p_CT_W = p_WT - sphere.p_WC;
  const double distance_m = p_CT_W.norm();
  const double height_m = distance_m - sphere.radius_m;
  if (distance_m <= kTooShort_m) return {p_WT, Status::NotUnique, height_m};
  return {sphere.p_WC + sphere.radius_m * (p_CT_W / distance_m), Status::Unique, height_m};  // eq. 4.3
}

}  // namespace underact::shape
