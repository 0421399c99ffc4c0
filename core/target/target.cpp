#include "core/target/target.h"

#include <cmath>

namespace underact::target {
namespace {

bool isFree(Side side, double height_m) noexcept UNDERACT_REAL_TIME {
  return (side == Side::Outside && height_m >= 0.0) || (side == Side::Inside && height_m <= 0.0);
}

/// In W; the height in the metric.
shape::Nearest nearestOf(const Constraint& constraint, const Vec3& p_W) noexcept UNDERACT_REAL_TIME {
  if (!constraint.weighted) return closestPoint(constraint.shape, p_W);
  shape::Nearest nearest = closestPoint(constraint.shape, constraint.scale.cwiseProduct(p_W));
  nearest.p_WP = nearest.p_WP.cwiseQuotient(constraint.scale);
  return nearest;
}

}  // namespace

Constraint makeConstraint(const shape::Shape& shape, Side side, const Vec3& stiffness) {
  const bool equal = stiffness.x() == stiffness.y() && stiffness.y() == stiffness.z();
  if (equal || std::holds_alternative<shape::Point>(shape)) return {shape, side};
  const Vec3 scale = (stiffness / stiffness.maxCoeff()).cwiseSqrt();
  return {shape::scaled(shape, scale), side, true, scale};
}

Target nearestTarget(const Constraint& constraint, const Vec3& p_WT) noexcept {
  const shape::Nearest nearest = nearestOf(constraint, p_WT);
  if (isFree(constraint.side, nearest.height_m)) return {p_WT, Status::Free, 0.0};
  if (nearest.status == shape::Status::NotUnique) return {p_WT, Status::Degenerate, std::abs(nearest.height_m)};
  if (!constraint.weighted) return {nearest.p_WP, Status::Unique, std::abs(nearest.height_m)};
  return {nearest.p_WP, Status::Unique, (nearest.p_WP - p_WT).norm()};
}

Target rubbedTarget(const Constraint& constraint, const Vec3& p_WT, const Target& target, const Whereabouts& where,
                    Grip& grip) noexcept {
  if (target.status != Status::Unique) {
    grip.holds = false;
    return target;
  }
  if (slides(constraint.friction, p_WT, target.p_WP, grip)) {
    if (constraint.mesh) {
      grip.p_WG = ontoMesh(*constraint.mesh, *where.mesh, grip.p_WG);
    } else if (constraint.curve) {
      grip.p_WG = ontoCurve(*constraint.curve, *where.curve, grip.p_WG);
    } else {
      const shape::Nearest nearest = nearestOf(constraint, grip.p_WG);
      grip.p_WG = nearest.status == shape::Status::Unique ? nearest.p_WP : target.p_WP;
    }
  }
  Target rubbed = target;
  rubbed.p_WP = grip.p_WG;
  return rubbed;
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
