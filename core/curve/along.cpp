#include "core/curve/along.h"

#include <algorithm>
#include <cmath>

namespace underact::curve {
namespace {

const Vec3& control(const Curve& curve, std::int32_t index) noexcept UNDERACT_REAL_TIME {
  return curve.controls_W[static_cast<std::size_t>(index)];
}

/// The last piece that begins at s_m or before.
std::int32_t pieceAt(const Curve& curve, double s_m) noexcept UNDERACT_REAL_TIME {
  std::int32_t low = 0, high = pieceCount(curve) - 1;
  while (low < high) {
    const std::int32_t middle = low + (high - low + 1) / 2;
    if (curve.s_m[static_cast<std::size_t>(middle)] <= s_m) {
      low = middle;
    } else {
      high = middle - 1;
    }
  }
  return low;
}

/// The parameter at which a cubic has the length length_m: Newton's steps, bisection where one leaves the bracket or
/// the last two have not halved it.
double placeAt(const Cubic& cubic, double length_m, double whole_m) noexcept UNDERACT_REAL_TIME {
  double low = 0.0, high = 1.0, u = length_m / whole_m, width = 1.0;
  for (int i = 0; i < kMaxPlacings && low < high; ++i) {
    const double off_m = lengthUpTo(cubic, u) - length_m, speed = velocityOf(cubic, u).norm();
    if (off_m == 0.0) break;
    (off_m < 0.0 ? low : high) = u;
    double next = speed > 0.0 ? u - off_m / speed : 2.0;
    if (i % 2 == 1) {
      if (high - low > 0.5 * width) next = 2.0;
      width = high - low;
    }
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - u) <= 0x1p-53 || next == low || next == high) break;
    u = next;
  }
  return u;
}

Vec3 unitOr(const Vec3& v, const Vec3& other) noexcept UNDERACT_REAL_TIME {
  const double length = v.norm();
  return length > 0.0 ? Vec3(v / length) : other;
}

}  // namespace

Cubic cubicOf(const Curve& curve, std::int32_t piece) noexcept {
  return {control(curve, 3 * piece), control(curve, 3 * piece + 1), control(curve, 3 * piece + 2),
          control(curve, 3 * piece + 3)};
}

Vec3 pointOn(const Curve& curve, std::int32_t piece, double u) noexcept {
  if (curve.kind == CurveKind::Spline) return pointOf(cubicOf(curve, piece), u);
  return (1.0 - u) * control(curve, piece) + u * control(curve, piece + 1);
}

Vec3 tangentOn(const Curve& curve, std::int32_t piece, double u) noexcept {
  if (curve.kind == CurveKind::Polyline)
    return unitOr(control(curve, piece + 1) - control(curve, piece), Vec3::UnitX());
  const Cubic cubic = cubicOf(curve, piece);
  const Vec3 velocity_W = velocityOf(cubic, u);
  // Where the speed vanishes, as where a path turns back, the tangent is that of the chord to the other end.
  const double share = velocity_W.norm(), chord_m = (cubic[3] - cubic[0]).norm();
  if (share > 1e-9 * chord_m) return velocity_W / share;
  return unitOr(cubic[3] - cubic[0], Vec3::UnitX());
}

double lengthUpTo(const Curve& curve, std::int32_t piece, double u) noexcept {
  if (curve.kind == CurveKind::Spline) return lengthUpTo(cubicOf(curve, piece), u);
  return u * (control(curve, piece + 1) - control(curve, piece)).norm();
}

double arcLengthAt(const Curve& curve, std::int32_t piece, double u) noexcept {
  const auto at = static_cast<std::size_t>(piece);
  if (u >= 1.0) return curve.s_m[at + 1];
  return std::min(curve.s_m[at] + lengthUpTo(curve, piece, u), curve.s_m[at + 1]);
}

Vec3 pointAt(const Curve& curve, double s_m) noexcept {
  const std::int32_t piece = pieceAt(curve, s_m);
  const auto at = static_cast<std::size_t>(piece);
  const double whole_m = curve.s_m[at + 1] - curve.s_m[at], length_m = s_m - curve.s_m[at];
  if (!(length_m > 0.0)) return pointOn(curve, piece, 0.0);
  if (!(length_m < whole_m)) return pointOn(curve, piece, 1.0);
  if (curve.kind == CurveKind::Polyline) return pointOn(curve, piece, length_m / whole_m);
  return pointOn(curve, piece, placeAt(cubicOf(curve, piece), length_m, whole_m));
}

double arcLengthBetween(const Curve& curve, double from_s_m, double to_s_m) noexcept {
  const double travel_m = to_s_m - from_s_m, whole_m = lengthOf(curve);
  if (!curve.is_closed || std::abs(travel_m) <= 0.5 * whole_m) return travel_m;
  return travel_m - whole_m * std::floor(travel_m / whole_m + 0.5);
}

double wrappedArcLength(const Curve& curve, double s_m) noexcept {
  const double whole_m = lengthOf(curve);
  if (!curve.is_closed) return std::clamp(s_m, 0.0, whole_m);
  const double round_m = s_m >= 0.0 && s_m < whole_m ? s_m : s_m - whole_m * std::floor(s_m / whole_m);
  return std::clamp(round_m, 0.0, whole_m);
}

}  // namespace underact::curve
