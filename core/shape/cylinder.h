#pragma once
#include "core/base/real_time.h"
#include "core/base/result.h"
#include "core/shape/nearest.h"

namespace underact::shape {

/// A cylinder, infinite along its axis. Made by makeCylinder(), which leaves radius_m > 0 and |axis_W| = 1.
struct Cylinder {
  Vec3 p_WC;  // any point of the axis
  Vec3 axis_W;
  double radius_m;
};
/// axis_W: any length but zero. Problems: a radius not above 0, no direction, a number that is not finite.
Result<Cylinder> makeCylinder(const Vec3& p_WC, const Vec3& axis_W, double radius_m, const SourceLocation& place);
/// p_WT: m, finite. NotUnique on the axis. Within 64 ulp of the largest coordinate, and near the axis 8 R ulp(|CT|) /
/// the distance from it more. Cost: constant. Source: Beckman 2007, eq. 4.22-4.26 (E points from the axis to the tip).
Nearest closestPoint(const Cylinder& cylinder, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::shape
