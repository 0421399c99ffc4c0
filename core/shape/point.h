#pragma once
#include "core/base/real_time.h"
#include "core/base/result.h"
#include "core/shape/nearest.h"

namespace underact::shape {

/// A point in the workspace.
struct Point {
  Vec3 p_WC;
};
/// Problems: a coordinate that is not finite.
Result<Point> makePoint(const Vec3& p_WC, const SourceLocation& place);
/// The point itself, always Unique. Source: Beckman 2007, eq. 4.1.
Nearest closestPoint(const Point& point, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME;
/// The point with each coordinate of W multiplied by scale (each > 0).
Point scaled(const Point& point, const Vec3& scale);

}  // namespace underact::shape
