#include "core/shape/shape.h"

#include <type_traits>
#include <utility>

namespace underact::shape {
namespace {

// By get_if, not std::visit: clang's effect analysis cannot see that visit does not throw.
template <std::size_t... kIndex>
Nearest choose(const Shape& shape, const Vec3& p_WT, std::index_sequence<kIndex...>) noexcept UNDERACT_REAL_TIME {
  Nearest nearest{p_WT, Status::NotUnique, 0.0};
  const auto attempt = [&](const auto* chosen) noexcept UNDERACT_REAL_TIME {
    if (chosen == nullptr) return false;
    nearest = closestPoint(*chosen, p_WT);
    return true;
  };
  (void)(attempt(std::get_if<kIndex>(&shape)) || ...);
  return nearest;
}

template <class Chosen, class... Any>
constexpr bool kIsOf = (std::is_same_v<Chosen, Any> || ...);

}  // namespace

Nearest closestPoint(const Shape& shape, const Vec3& p_WT) noexcept {
  return choose(shape, p_WT, std::make_index_sequence<std::variant_size_v<Shape>>{});
}

bool hasSides(const Shape& shape) {
  return !(std::holds_alternative<Point>(shape) || std::holds_alternative<Line>(shape) ||
           std::holds_alternative<Circle>(shape) || std::holds_alternative<Ellipse>(shape));
}

Shape scaled(const Shape& shape, const Vec3& scale) {
  const auto times = [&](const Vec3& v) -> Vec3 { return scale.cwiseProduct(v); };
  return std::visit(
      [&](const auto& chosen) -> Shape {
        using Chosen = std::decay_t<decltype(chosen)>;
        if constexpr (std::is_same_v<Chosen, Point>) {
          return Point{times(chosen.p_WC)};
        } else if constexpr (std::is_same_v<Chosen, Line>) {
          return Line{times(chosen.p_WC), times(chosen.axis_W).normalized()};
        } else if constexpr (std::is_same_v<Chosen, Plane>) {
          return Plane{times(chosen.p_WC), chosen.normal_W.cwiseQuotient(scale).normalized()};
        } else if constexpr (kIsOf<Chosen, Sphere, Circle, Cylinder, Box>) {
          return shape::scaled(chosen, scale);
        } else {
          return chosen;  // already scaled
        }
      },
      shape);
}

}  // namespace underact::shape
