#pragma once
#include "core/base/real_time.h"
#include "core/base/trig.h"
#include "core/base/types.h"

namespace underact::chain {

/// v turned about a unit axis by the angle of `turn`. Source: Rodrigues' formula.
inline Vec3 turned(const Vec3& v, const Vec3& axis, const SinCos& turn) noexcept UNDERACT_REAL_TIME {
  return turn.cos * v + turn.sin * axis.cross(v) + ((1.0 - turn.cos) * axis.dot(v)) * axis;
}

/// The same angle the other way round.
inline SinCos reversed(const SinCos& turn) noexcept UNDERACT_REAL_TIME {
  return {-turn.sin, turn.cos};
}

/// The angle in (-pi, pi], rad, that turns u about a unit axis towards v; components along the axis do not count.
/// 0 where one of them lies on the axis.
inline double angleAbout(const Vec3& axis, const Vec3& u, const Vec3& v) noexcept UNDERACT_REAL_TIME {
  return atan2Of(axis.dot(u.cross(v)), u.dot(v) - axis.dot(u) * axis.dot(v));
}

}  // namespace underact::chain
