#pragma once
#include <cstdint>

#include "core/base/real_time.h"
#include "core/curve/cubic.h"
#include "core/curve/curve.h"

namespace underact::curve {

// A curve by its pieces, and by arc length. piece: an existing one; u in [0, 1].

/// The controls of a piece of a spline.
Cubic cubicOf(const Curve& curve, std::int32_t piece) noexcept UNDERACT_REAL_TIME;

/// The point at u, m: of a line by interpolation, of a spline as pointOf().
Vec3 pointOn(const Curve& curve, std::int32_t piece, double u) noexcept UNDERACT_REAL_TIME;

/// The unit tangent, in the order of the points. Where a spline turns back at a point, the direction in which it leaves
/// it (at the piece's end: in which it arrived).
Vec3 tangentOn(const Curve& curve, std::int32_t piece, double u) noexcept UNDERACT_REAL_TIME;

/// Arc length of the piece from its begin to u, m: of a line exact, of a spline see splineControls().
double lengthUpTo(const Curve& curve, std::int32_t piece, double u) noexcept UNDERACT_REAL_TIME;

/// Arc length from the begin of the curve, m.
double arcLengthAt(const Curve& curve, std::int32_t piece, double u) noexcept UNDERACT_REAL_TIME;

/// The point at an arc length, m, clamped to the curve's ends; within 1e-15 m and the rounding of the coordinates of
/// the point for which arcLengthAt() gives s_m. Cost: logarithmic in the pieces, and at most kMaxPlacings quadratures.
Vec3 pointAt(const Curve& curve, double s_m) noexcept UNDERACT_REAL_TIME;
inline constexpr int kMaxPlacings = 64;

/// The signed distance from one arc length to another, m: of a closed curve the shorter one, in [-half, half] of its
/// length.
double arcLengthBetween(const Curve& curve, double from_s_m, double to_s_m) noexcept UNDERACT_REAL_TIME;

/// An arc length brought into the curve's range: clamped to its ends, or wrapped round a closed one.
double wrappedArcLength(const Curve& curve, double s_m) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::curve
