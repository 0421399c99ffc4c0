#pragma once
#include "core/base/real_time.h"
#include "core/base/result.h"
#include "core/shape/nearest.h"

namespace underact::shape {

/// An infinite plane. Made by makePlane(), which leaves |normal_W| = 1. Its outer side is where normal_W points.
struct Plane {
  Vec3 p_WC;  // any point of it
  Vec3 normal_W;
};
/// normal_W: any length but zero. Problems: no direction, a number that is not finite.
Result<Plane> makePlane(const Vec3& p_WC, const Vec3& normal_W, const SourceLocation& place);
/// p_WT: m, finite. Always Unique. Within 64 ulp of the largest coordinate. Cost: constant.
/// Source: Beckman 2007, eq. 4.11-4.14; erratum code 4.4 (divide by |N| squared; unit normals here).
Nearest closestPoint(const Plane& plane, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME;
/// The plane with each coordinate of W multiplied by scale (each > 0).
Plane scaled(const Plane& plane, const Vec3& scale);

}  // namespace underact::shape
