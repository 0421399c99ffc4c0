#pragma once
#include "core/base/real_time.h"
#include "core/base/result.h"
#include "core/shape/nearest.h"

namespace underact::shape {

/// An infinite line. Made by makeLine(), which leaves |axis_W| = 1.
struct Line {
  Vec3 p_WC;  // any point of it
  Vec3 axis_W;
};
/// direction_W: any length but zero. Problems: no direction, a number that is not finite.
Result<Line> makeLine(const Vec3& p_WC, const Vec3& direction_W, const SourceLocation& place);
/// p_WT: m, finite. Always Unique. Within 64 ulp of the largest coordinate. Cost: constant.
/// Source: Beckman 2007, eq. 4.5-4.9; erratum 4.7-4.9 (the printed sign mirrors the foot through the line's point).
Nearest closestPoint(const Line& line, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME;
/// The line with each coordinate of W multiplied by scale (each > 0).
Line scaled(const Line& line, const Vec3& scale);

}  // namespace underact::shape
