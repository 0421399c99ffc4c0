#pragma once
#include <variant>

#include "core/shape/box.h"
#include "core/shape/circle.h"
#include "core/shape/cylinder.h"
#include "core/shape/ellipse.h"
#include "core/shape/ellipsoid.h"
#include "core/shape/line.h"
#include "core/shape/parallelepiped.h"
#include "core/shape/plane.h"
#include "core/shape/point.h"
#include "core/shape/sphere.h"

namespace underact::shape {

/// All shapes that the stylus can be held to. The last four are the others in the metric of unequal gains, see
/// scaled().
using Shape = std::variant<Point, Sphere, Line, Plane, Circle, Cylinder, Box, Ellipsoid, Ellipse, EllipticCylinder,
                           Parallelepiped>;

/// The point of the shape nearest to p_WT (m, finite): see each shape's own closestPoint().
Nearest closestPoint(const Shape& shape, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME;

/// Whether the shape separates the workspace into inside and outside, so that it can be a wall.
bool hasSides(const Shape& shape);

/// The shape with each coordinate of W multiplied by scale (each > 0): the nearest point of it is the nearest one in
/// the metric of scale^2.
Shape scaled(const Shape& shape, const Vec3& scale);

}  // namespace underact::shape
