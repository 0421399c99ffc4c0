#pragma once
#include "core/base/real_time.h"
#include "core/base/result.h"
#include "core/shape/nearest.h"
#include "core/shape/sphere.h"

namespace underact::shape {

/// The surface of an ellipsoid. Made by makeEllipsoid(), which leaves semi_m > 0 and R_WB a rotation; also a sphere in
/// the metric of unequal gains.
struct Ellipsoid {
  Vec3 p_WC;
  Vec3 semi_m;                   // half axes
  Mat3 R_WB = Mat3::Identity();  // their directions, as columns
};
/// Problems: a half axis not above 0, R_WB no rotation (as of a box), a number that is not finite. R_WB is made
/// orthonormal to the last bit.
Result<Ellipsoid> makeEllipsoid(const Vec3& p_WC, const Vec3& semi_m, const Mat3& R_WB, const SourceLocation& place);
/// The shape with each coordinate of W multiplied by scale (each > 0).
Ellipsoid scaled(const Sphere& sphere, const Vec3& scale);
Ellipsoid scaled(const Ellipsoid& ellipsoid, const Vec3& scale);
/// NotUnique on the disc in its middle. Off the surface by at most 64 ulp of the largest coordinate, and farther from
/// the tip than the nearest point by at most as much; so the height, too. Source: see quadric.h.
Nearest closestPoint(const Ellipsoid& ellipsoid, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::shape
