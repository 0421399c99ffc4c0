#pragma once
#include <type_traits>
#include <utility>
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

/// All shapes that the stylus can be held to. Those at the end are the others in the metric of unequal gains, see
/// scaled().
using Shape = std::variant<Point, Sphere, Line, Plane, Circle, Cylinder, Box, Ellipsoid, Ellipse, EllipticCylinder,
                           Parallelepiped>;

/// Calls call(chosen) with the shape that it is. By get_if, not std::visit: clang's effect analysis cannot see that
/// visit does not throw.
template <class AnyShape, class Call>
void withChosen(AnyShape& shape, const Call& call) noexcept UNDERACT_REAL_TIME {
  const auto attempt = [&](auto* chosen) noexcept UNDERACT_REAL_TIME {
    if (chosen != nullptr) call(*chosen);
    return chosen != nullptr;
  };
  const auto attemptAll = [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) noexcept UNDERACT_REAL_TIME {
    (void)(attempt(std::get_if<kIndex>(&shape)) || ...);
  };
  attemptAll(std::make_index_sequence<std::variant_size_v<Shape>>{});
}

/// The point of the shape nearest to p_WT (m, finite): see each shape's own closestPoint().
Nearest closestPoint(const Shape& shape, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME;

/// Whether the shape separates the workspace into inside and outside, so that it can be a wall.
bool hasSides(const Shape& shape);

/// The shape with each coordinate of W multiplied by scale (each > 0): the nearest point of it is the nearest one in
/// the metric of scale^2. One that is scaled already stays.
Shape scaled(const Shape& shape, const Vec3& scale);

/// Whether a shape has a scaled() of its own; the others are what these give.
template <class One>
inline constexpr bool kIsPlain = !std::is_same_v<decltype(scaled(std::declval<One>(), std::declval<Vec3>())), Shape>;

}  // namespace underact::shape
