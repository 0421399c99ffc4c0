#pragma once
#include <array>
#include <cmath>

#include "core/base/axis_geometry.h"
#include "core/base/trig.h"
#include "core/base/units.h"
#include "core/chain/chain.h"
#include "core/chain/roots.h"
#include "core/chain/rotation.h"

namespace underact::chain {

// Inside the room: where a point is taken by one joint, and for which values of it a condition holds.

inline constexpr double kSame = 1e-9;  // rad, and of the reach: axes count as parallel, or as meeting

/// Whether two unit axes are parallel, or opposed.
inline bool areParallel(const Vec3& a, const Vec3& b) noexcept UNDERACT_REAL_TIME {
  return a.cross(b).norm() <= kSame;
}

/// The point of axis a that is nearest to axis b; they are not parallel.
inline Vec3 nearestOn(const Joint& a, const Joint& b) noexcept UNDERACT_REAL_TIME {
  const Vec3 common = a.axis_W.cross(b.axis_W);
  return a.p_WJ + (b.p_WJ - a.p_WJ).cross(b.axis_W).dot(common) / common.squaredNorm() * a.axis_W;
}

/// Up to four values of a joint, rad or m.
using JointRoots = Roots;

/// The roots of fixed + cos q cosine + sin q sine = 0, the amplitude measured by scale. Two roots, one where they
/// coincide (to 1e-12 of the amplitude), none out of reach by more than 1e-9 of it. free: the equation holds for every
/// angle.
struct AngleRoots {
  JointRoots roots;
  bool free = false;
};
/// All three in the unit of scale; not finite in, no roots.
inline AngleRoots rootsOfAngle(double fixed, double cosine, double sine, double scale) noexcept UNDERACT_REAL_TIME {
  AngleRoots found;
  const double amplitude = std::sqrt(cosine * cosine + sine * sine);
  if (!(amplitude > 1e-12 * scale)) {
    found.free = std::abs(fixed) <= kSame * scale;
    return found;
  }
  const double inside = amplitude - std::abs(fixed);
  if (!(inside >= -kSame * amplitude)) return found;
  const double middle_rad = atan2Of(sine, cosine);
  const bool merged = inside <= 1e-12 * amplitude;
  const double across = merged ? 0.0 : std::sqrt(inside * (amplitude + std::abs(fixed)));
  const double half_rad = atan2Of(across, -fixed);
  found.roots.all = {middle_rad + half_rad, middle_rad - half_rad};
  found.roots.count = merged ? 1 : 2;
  return found;
}

/// A point that a joint moves: fixed + cos q cosine + sin q sine (revolute), or fixed + q cosine (prismatic).
struct MovedPoint {
  JointType type = JointType::Revolute;
  Vec3 fixed = Vec3::Zero();
  Vec3 cosine = Vec3::Zero();
  Vec3 sine = Vec3::Zero();
  /// The point with the joint at q.
  Vec3 at(double q) const noexcept UNDERACT_REAL_TIME {
    if (type == JointType::Prismatic) return fixed + q * cosine;
    const auto [sin, cos] = sinCos(q);
    return fixed + cos * cosine + sin * sine;
  }
};
/// The point p_W of the link behind the joint, m, with all joints at 0.
inline MovedPoint movedBy(const Joint& joint, const Vec3& p_W) noexcept UNDERACT_REAL_TIME {
  if (joint.type == JointType::Prismatic) return {joint.type, p_W, joint.axis_W, Vec3::Zero()};
  const Vec3 arm_W = perpendicularPart(joint.axis_W, p_W - joint.p_WJ);
  return {joint.type, p_W - arm_W, arm_W, joint.axis_W.cross(arm_W)};
}

/// A condition on such a point as polynomials in one unknown t: numerator over denominator^power. Revolute: t =
/// tan(q / 2), or tan((q - pi) / 2) on the far side, each in [-1, 1], and the denominator is 1 + t^2; prismatic: t = q
/// and 1.
struct UnknownOfJoint {
  JointType type = JointType::Revolute;
  bool far = false;
  /// 1 + t^2, or 1.
  Quadratic denominator() const noexcept UNDERACT_REAL_TIME {
    return type == JointType::Revolute ? Quadratic{1.0, 0.0, 1.0} : Quadratic{1.0, 0.0, 0.0};
  }
  /// direction . point, times the denominator.
  Quadratic along(const Vec3& direction, const MovedPoint& point) const noexcept UNDERACT_REAL_TIME {
    return of(direction.dot(point.fixed), direction.dot(point.cosine), direction.dot(point.sine));
  }
  /// |point - from|^2, times the denominator.
  Quadratic squaredDistance(const Vec3& from, const MovedPoint& point) const noexcept UNDERACT_REAL_TIME {
    const Vec3 offset = point.fixed - from;
    if (type == JointType::Prismatic) return {offset.squaredNorm(), 2.0 * offset.dot(point.cosine), 1.0};
    return of(offset.squaredNorm() + point.cosine.squaredNorm(), 2.0 * offset.dot(point.cosine),
              2.0 * offset.dot(point.sine));
  }
  /// The joint for a root, rad or m.
  double value(double t) const noexcept UNDERACT_REAL_TIME {
    if (type == JointType::Prismatic) return t;
    return 2.0 * atan2Of(t, 1.0) + (far ? kPi : 0.0);
  }
  /// The joint for each root of a polynomial.
  JointRoots valuesOf(const Quartic& polynomial) const noexcept UNDERACT_REAL_TIME {
    Roots roots = type == JointType::Prismatic ? rootsOf(polynomial) : rootsWithin(polynomial, -1.0, 1.0);
    for (std::size_t i = 0; i < roots.count; ++i) roots.all[i] = value(roots.all[i]);
    return roots;
  }

 private:
  Quadratic of(double fixed, double cosine, double sine) const noexcept UNDERACT_REAL_TIME {
    if (type == JointType::Prismatic) return {fixed, cosine, 0.0};
    const double c = far ? -cosine : cosine, s = far ? -sine : sine;
    return {fixed + c, 2.0 * s, fixed - c};
  }
};

}  // namespace underact::chain
