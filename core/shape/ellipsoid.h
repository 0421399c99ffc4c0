#pragma once
#include "core/base/real_time.h"
#include "core/shape/nearest.h"
#include "core/shape/sphere.h"

namespace underact::shape {

/// A sphere in the metric of unequal gains: half axes along x, y, z of W, all above 0.
struct Ellipsoid {
  Vec3 p_WC;
  Vec3 semi_m;
};
/// The sphere with each coordinate of W multiplied by scale (each > 0).
Ellipsoid scaled(const Sphere& sphere, const Vec3& scale);
/// NotUnique on the disc in its middle. Off the surface by at most 64 ulp of the largest coordinate, and farther from
/// the tip than the nearest point by at most as much; so the height, too. Source: see quadric.h.
Nearest closestPoint(const Ellipsoid& ellipsoid, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::shape
