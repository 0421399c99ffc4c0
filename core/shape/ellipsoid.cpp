#include "core/shape/ellipsoid.h"

#include "core/shape/quadric.h"

namespace underact::shape {

Ellipsoid scaled(const Sphere& sphere, const Vec3& scale) {
  return {scale.cwiseProduct(sphere.p_WC), sphere.radius_m * scale};
}

Nearest closestPoint(const Ellipsoid& ellipsoid, const Vec3& p_WT) noexcept {
  const Vec3 p_CT_W = p_WT - ellipsoid.p_WC;
  const OnQuadric<3> on = nearestOnQuadric<3>({ellipsoid.semi_m.x(), ellipsoid.semi_m.y(), ellipsoid.semi_m.z()},
                                              {p_CT_W.x(), p_CT_W.y(), p_CT_W.z()});
  const double sign = on.inside ? -1.0 : 1.0;
  if (on.status == Status::NotUnique) return {p_WT, Status::NotUnique, sign * on.apart};
  const Vec3 p_CP_W(on.x[0], on.x[1], on.x[2]);
  return {ellipsoid.p_WC + p_CP_W, Status::Unique, sign * (p_CT_W - p_CP_W).norm()};
}

}  // namespace underact::shape
