#pragma once
#include <cmath>

#include "core/base/real_time.h"
#include "core/base/trig.h"
#include "core/base/types.h"
#include "core/base/units.h"

namespace underact {

/// v without its component along the unit axis_W; projected twice, since near the axis the first projection leaves an
/// error as large as its result.
inline Vec3 perpendicularPart(const Vec3& axis_W, Vec3 v_W) noexcept UNDERACT_REAL_TIME {
  v_W -= v_W.dot(axis_W) * axis_W;
  v_W -= v_W.dot(axis_W) * axis_W;
  return v_W;
}

/// A unit vector at right angles to a unit axis, always the same: the coordinate axis nearest to a right angle with it
/// (the first of equals), made perpendicular.
inline Vec3 referencePerpendicular(const Vec3& axis_W) noexcept UNDERACT_REAL_TIME {
  Eigen::Index max = 0;
  for (Eigen::Index axis = 1; axis < 3; ++axis) {
    if (std::abs(axis_W[axis]) < std::abs(axis_W[max])) max = axis;
  }
  Vec3 direction_W = Vec3::Zero();
  direction_W[max] = 1.0;
  const Vec3 perpendicular_W = perpendicularPart(axis_W, direction_W);
  return perpendicular_W / perpendicular_W.norm();
}

/// The angle of v about a unit axis, from referencePerpendicular(), rad, in (-pi, pi]; 0 where v lies on the axis.
inline double angleAround(const Vec3& axis_W, const Vec3& v_W) noexcept UNDERACT_REAL_TIME {
  const Vec3 u_W = referencePerpendicular(axis_W);
  return atan2Of(v_W.dot(axis_W.cross(u_W)), v_W.dot(u_W));
}

/// An equal angle in [-pi, pi], rad; one in that range keeps its bits.
inline double wrapped(double angle_rad) noexcept UNDERACT_REAL_TIME {
  return std::abs(angle_rad) <= kPi ? angle_rad : angle_rad - 2.0 * kPi * std::floor(angle_rad / (2.0 * kPi) + 0.5);
}

}  // namespace underact
