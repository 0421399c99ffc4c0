#include "core/target/shape_target.h"

#include <cmath>

namespace underact::target {
namespace {

bool isFree(Side side, double height_m) noexcept UNDERACT_REAL_TIME {
  return (side == Side::Outside && height_m >= 0.0) || (side == Side::Inside && height_m <= 0.0);
}

/// The nearest point in W, with the height in the metric.
shape::Nearest nearestOf(const NearestOnShape& held, const Vec3& p_W) noexcept UNDERACT_REAL_TIME {
  if (!held.weighted) return closestPoint(held.shape, p_W);
  shape::Nearest nearest = closestPoint(held.shape, held.scale.cwiseProduct(p_W));
  nearest.p_WP = nearest.p_WP.cwiseQuotient(held.scale);
  return nearest;
}

}  // namespace

NearestOnShape nearestOn(const shape::Shape& shape, const Vec3& stiffness) {
  const bool equal = stiffness.x() == stiffness.y() && stiffness.y() == stiffness.z();
  if (equal || std::holds_alternative<shape::Point>(shape)) return {shape};
  const Vec3 scale = (stiffness / stiffness.maxCoeff()).cwiseSqrt();
  return {shape::scaled(shape, scale), true, scale};
}

Target nearestTarget(const NearestOnShape& held, Side side, const Vec3& p_WT) noexcept {
  const shape::Nearest nearest = nearestOf(held, p_WT);
  if (isFree(side, nearest.height_m)) return {p_WT, Status::Free, 0.0};
  if (nearest.status == shape::Status::NotUnique) return {p_WT, Status::Degenerate, std::abs(nearest.height_m)};
  if (!held.weighted) return {nearest.p_WP, Status::Unique, std::abs(nearest.height_m)};
  return {nearest.p_WP, Status::Unique, (nearest.p_WP - p_WT).norm()};
}

Vec3 ontoShape(const NearestOnShape& held, const Vec3& p_W, const Vec3& p_WP) noexcept {
  const shape::Nearest nearest = nearestOf(held, p_W);
  return nearest.status == shape::Status::Unique ? nearest.p_WP : p_WP;
}

Vec3 ontoShape(const InfluencedShape& held, const Vec3& p_W, const Vec3& p_WP) noexcept {
  const shape::Nearest nearest = closestPoint(held.shape, p_W);
  return nearest.status == shape::Status::Unique ? nearest.p_WP : p_WP;
}

}  // namespace underact::target
