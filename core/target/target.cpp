#include "core/target/target.h"

#include <cmath>

namespace underact::target {
namespace {

bool isFree(Side side, double height_m) noexcept UNDERACT_REAL_TIME {
  return (side == Side::Outside && height_m >= 0.0) || (side == Side::Inside && height_m <= 0.0);
}

}  // namespace

Constraint makeConstraint(const shape::Shape& shape, Side side, const Vec3& stiffness) {
  const bool equal = stiffness.x() == stiffness.y() && stiffness.y() == stiffness.z();
  if (equal || std::holds_alternative<shape::Point>(shape)) return {shape, side};
  const Vec3 scale = (stiffness / stiffness.maxCoeff()).cwiseSqrt();
  return {shape::scaled(shape, scale), side, true, scale};
}

Target nearestTarget(const Constraint& constraint, const Vec3& p_WT) noexcept {
  const Vec3 at = constraint.weighted ? Vec3(constraint.scale.cwiseProduct(p_WT)) : p_WT;
  const shape::Nearest nearest = closestPoint(constraint.shape, at);
  if (isFree(constraint.side, nearest.height_m)) return {p_WT, Status::Free, 0.0};
  if (nearest.status == shape::Status::NotUnique) return {p_WT, Status::Degenerate, std::abs(nearest.height_m)};
  if (!constraint.weighted) return {nearest.p_WP, Status::Unique, std::abs(nearest.height_m)};
  const Vec3 p_WP = nearest.p_WP.cwiseQuotient(constraint.scale);
  return {p_WP, Status::Unique, (p_WP - p_WT).norm()};
}

Target influencedTarget(const Constraint& constraint, const Vec3& p_WT, const Vec3& stylus_W, double dt_s,
                        InfluenceState& state) noexcept {
  const Influenced found = influencedTarget(constraint.shape, constraint.influence, p_WT, stylus_W, dt_s, state);
  const Status status = found.is_unique ? Status::Unique : Status::Degenerate;
  return {found.p_WP, status, found.distance_m, found.angles, found.arc};
}

const char* name(Status status) {
  switch (status) {
    case Status::Unique:
      return "unique";
    case Status::Degenerate:
      return "degenerate";
    case Status::Free:
      return "free";
  }
  return "degenerate";
}

}  // namespace underact::target
