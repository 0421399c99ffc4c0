#pragma once
#include "core/base/real_time.h"
#include "core/base/result.h"
#include "core/shape/nearest.h"

namespace underact::shape {

/// A circle in the workspace. Made by makeCircle(), which leaves radius_m > 0 and |axis_W| = 1.
struct Circle {
  Vec3 p_WC;
  Vec3 axis_W;
  double radius_m;
};
/// normal_W: any length but zero. Problems: a radius not above 0, no direction, a number that is not finite.
Result<Circle> makeCircle(const Vec3& p_WC, const Vec3& normal_W, double radius_m, const SourceLocation& place);
/// p_WT: m, finite. NotUnique on the axis. Within 64 ulp of the largest coordinate, and near the axis 8 R ulp(|CT|) /
/// the distance from it more. Cost: constant. Source: Beckman 2007, eq. 4.16-4.20; erratum 4.20 (V ends at T's foot,
/// not at T).
Nearest closestPoint(const Circle& circle, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::shape
