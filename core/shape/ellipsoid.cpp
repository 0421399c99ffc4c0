#include "core/shape/ellipsoid.h"

#include "core/base/nearest_rotation.h"
#include "core/base/norms.h"
#include "core/base/singular_values.h"
#include "core/base/translate.h"
#include "core/shape/quadric.h"

namespace underact::shape {

Result<Ellipsoid> makeEllipsoid(const Vec3& p_WC, const Vec3& semi_m, const Mat3& R_WB, const SourceLocation& place) {
  Problems problems;
  if (!p_WC.allFinite())
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "The centre is not a finite point.")), place});
  if (!(semi_m.allFinite() && minOf(semi_m) > 0.0))
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "Every size must be above 0.")), place});
  if (Sentence sentence = rotationProblem(R_WB); !sentence.empty()) problems.push_back({std::move(sentence), place});
  if (!problems.empty()) return problems;
  return Ellipsoid{p_WC, semi_m, R_WB == Mat3::Identity() ? R_WB : nearestRotation(R_WB)};
}

Ellipsoid scaled(const Sphere& sphere, const Vec3& scale) {
  return {scale.cwiseProduct(sphere.p_WC), sphere.radius_m * scale};
}

Ellipsoid scaled(const Ellipsoid& ellipsoid, const Vec3& scale) {
  const SingularValues half = leftSingularValues(scale.asDiagonal() * ellipsoid.R_WB * ellipsoid.semi_m.asDiagonal());
  return {scale.cwiseProduct(ellipsoid.p_WC), half.values, half.vectors};
}

Nearest closestPoint(const Ellipsoid& ellipsoid, const Vec3& p_WT) noexcept {
  const Mat3& R_WB = ellipsoid.R_WB;
  // As a sphere in the metric of gains is; whichever way its axes point, it is its own mirror image.
  const bool is_along_W = R_WB(0, 1) == 0.0 && R_WB(0, 2) == 0.0 && R_WB(1, 2) == 0.0;
  Vec3 d_B = p_WT - ellipsoid.p_WC;
  if (!is_along_W) d_B = R_WB.transpose() * d_B;
  const OnQuadric<3> on = nearestOnQuadric<3>({ellipsoid.semi_m.x(), ellipsoid.semi_m.y(), ellipsoid.semi_m.z()},
                                              {d_B.x(), d_B.y(), d_B.z()});
  const double sign = on.inside ? -1.0 : 1.0;
  if (on.status == Status::NotUnique) return {p_WT, Status::NotUnique, sign * on.apart};
  Vec3 q(on.x[0], on.x[1], on.x[2]);
  const double height_m = sign * (d_B - q).norm();
  if (!is_along_W) q = R_WB * q;
  return {ellipsoid.p_WC + q, Status::Unique, height_m};
}

}  // namespace underact::shape
