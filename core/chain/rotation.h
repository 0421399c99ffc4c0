#pragma once
#include <cmath>

#include "core/base/real_time.h"
#include "core/base/trig.h"
#include "core/base/types.h"
#include "core/base/units.h"

namespace underact::chain {

/// v rotated about a unit axis by the angle of `turn`. Source: Rodrigues' formula.
inline Vec3 rotated(const Vec3& v, const Vec3& axis, const SinCos& turn) noexcept UNDERACT_REAL_TIME {
  return turn.cos * v + turn.sin * axis.cross(v) + ((1.0 - turn.cos) * axis.dot(v)) * axis;
}

/// The opposite angle.
inline SinCos reversed(const SinCos& turn) noexcept UNDERACT_REAL_TIME {
  return {-turn.sin, turn.cos};
}

/// A rotation about a given axis: its angle, and the sine and cosine of it.
struct AxisRotation {
  double angle_rad = 0.0;
  SinCos turn;
};

/// The rotation about a unit axis, its angle in (-pi, pi], that takes u towards v; components along the axis do not
/// count. None where one of them lies on the axis. Both are first made perpendicular to the axis: near it their
/// products would consist of rounding only.
inline AxisRotation rotationAbout(const Vec3& axis, const Vec3& u, const Vec3& v) noexcept UNDERACT_REAL_TIME {
  const Vec3 a = axis.cross(u), b = axis.cross(v);
  const double sine = axis.dot(a.cross(b)), cosine = a.dot(b), length = std::sqrt(sine * sine + cosine * cosine);
  if (!(length > 0.0)) return {};
  const double angle_rad = atan2Of(sine, cosine);
  return {angle_rad > -kPi ? angle_rad : kPi, {sine / length, cosine / length}};
}

/// Its angle alone.
inline double angleAbout(const Vec3& axis, const Vec3& u, const Vec3& v) noexcept UNDERACT_REAL_TIME {
  const Vec3 a = axis.cross(u), b = axis.cross(v);
  const double angle_rad = atan2Of(axis.dot(a.cross(b)), a.dot(b));
  return angle_rad > -kPi ? angle_rad : kPi;
}

}  // namespace underact::chain
