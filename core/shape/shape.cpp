#include "core/shape/shape.h"

namespace underact::shape {

Nearest closestPoint(const Shape& shape, const Vec3& p_WT) noexcept {
  Nearest nearest{p_WT, Status::NotUnique, 0.0};
  withChosen(shape, [&](const auto& chosen) noexcept UNDERACT_REAL_TIME { nearest = closestPoint(chosen, p_WT); });
  return nearest;
}

bool hasSides(const Shape& shape) {
  return !(std::holds_alternative<Point>(shape) || std::holds_alternative<Line>(shape) ||
           std::holds_alternative<Circle>(shape) || std::holds_alternative<Ellipse>(shape));
}

Shape scaled(const Shape& shape, const Vec3& scale) {
  return std::visit(
      [&](const auto& chosen) -> Shape {
        if constexpr (kIsPlain<decltype(chosen)>)
          return scaled(chosen, scale);
        else
          return chosen;
      },
      shape);
}

}  // namespace underact::shape
