#pragma once
#include "core/base/real_time.h"
#include "core/shape/circle.h"
#include "core/shape/cylinder.h"
#include "core/shape/nearest.h"

namespace underact::shape {

/// A circle in the metric of unequal gains. first_W, second_W: unit, along the half axes; axis_W at right angles.
struct Ellipse {
  Vec3 p_WC;
  Vec3 first_W;
  Vec3 second_W;
  Vec3 axis_W;
  double first_m;
  double second_m;
};
/// A cylinder in that metric: infinite along axis_W, with an elliptic section.
struct EllipticCylinder {
  Ellipse section;
};
/// The shape with each coordinate of W multiplied by scale (each > 0).
Ellipse scaled(const Circle& circle, const Vec3& scale);
EllipticCylinder scaled(const Cylinder& cylinder, const Vec3& scale);
/// NotUnique over the middle of the longer axis. Off the curve by at most 64 ulp of the largest coordinate, and farther
/// from the tip than the nearest point by at most as much; so the distance, too. Source: see quadric.h.
Nearest closestPoint(const Ellipse& ellipse, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME;
Nearest closestPoint(const EllipticCylinder& cylinder, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::shape
