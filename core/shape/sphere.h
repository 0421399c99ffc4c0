#pragma once
#include "core/base/real_time.h"
#include "core/base/result.h"
#include "core/shape/nearest.h"

namespace underact::shape {

/// A sphere in the workspace. Made by makeSphere(), which leaves radius_m > 0.
struct Sphere {
  Vec3 p_WC;
  double radius_m;
};
/// Problems: a radius not above 0, a number that is not finite.
Result<Sphere> makeSphere(const Vec3& p_WC, double radius_m, const SourceLocation& place);
/// p_WT: m, finite. NotUnique at the centre. Within 64 ulp of the largest coordinate. Cost: constant.
/// Source: Beckman 2007, eq. 4.2, 4.3.
Nearest closestPoint(const Sphere& sphere, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::shape
