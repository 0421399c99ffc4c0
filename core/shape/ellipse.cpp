#include "core/shape/ellipse.h"

#include <cmath>

#include "core/base/singular_values.h"
#include "core/shape/quadric.h"

namespace underact::shape {
namespace {

using Span = Eigen::Matrix<double, 3, 2>;  // the ellipse p_WC + span (cos a, sin a)

/// The two vectors R u, R v that span a circle at right angles to axis_W.
Span spanAcross(const Vec3& axis_W, double radius_m) {
  const Vec3 u_W = axis_W.unitOrthogonal();
  Span span;
  span << radius_m * u_W, radius_m * axis_W.cross(u_W);
  return span;
}

Ellipse fromSpan(const Vec3& p_WC, const Span& span_W) {
  const auto [half_m, axes_W] = ellipseAxes(span_W);
  return {p_WC, axes_W.col(0), axes_W.col(1), axes_W.col(2), half_m[0], half_m[1]};
}

struct InPlane {
  OnQuadric<2> on;
  Vec3 p_WP;
};

InPlane nearestInPlane(const Ellipse& ellipse, const Vec3& p_CT_W) noexcept {
  const OnQuadric<2> on = nearestOnQuadric<2>({ellipse.first_m, ellipse.second_m},
                                              {p_CT_W.dot(ellipse.first_W), p_CT_W.dot(ellipse.second_W)});
  return {on, ellipse.p_WC + on.x[0] * ellipse.first_W + on.x[1] * ellipse.second_W};
}

}  // namespace

Ellipse scaled(const Circle& circle, const Vec3& scale) {
  return fromSpan(scale.cwiseProduct(circle.p_WC), scale.asDiagonal() * spanAcross(circle.axis_W, circle.radius_m));
}

EllipticCylinder scaled(const Cylinder& cylinder, const Vec3& scale) {
  const Vec3 axis_W = scale.cwiseProduct(cylinder.axis_W).normalized();
  Span span_W = scale.asDiagonal() * spanAcross(cylinder.axis_W, cylinder.radius_m);
  for (int pass = 0; pass < 2; ++pass) span_W -= axis_W * (axis_W.transpose() * span_W);  // again, as on the circle
  return {fromSpan(scale.cwiseProduct(cylinder.p_WC), span_W)};
}

Nearest closestPoint(const Ellipse& ellipse, const Vec3& p_WT) noexcept {
  const auto [on, p_WP] = nearestInPlane(ellipse, p_WT - ellipse.p_WC);
  if (on.status == Status::NotUnique) {
    const double along_m = (p_WT - ellipse.p_WC).dot(ellipse.axis_W);
    return {p_WT, Status::NotUnique, std::sqrt(along_m * along_m + on.apart * on.apart)};
  }
  return {p_WP, Status::Unique, (p_WT - p_WP).norm()};
}

Nearest closestPoint(const EllipticCylinder& cylinder, const Vec3& p_WT) noexcept {
  const Ellipse& section = cylinder.section;
  const Vec3 p_CT_W = p_WT - section.p_WC;
  const auto [on, p_WU] = nearestInPlane(section, p_CT_W);
  const double sign = on.inside ? -1.0 : 1.0;
  if (on.status == Status::NotUnique) return {p_WT, Status::NotUnique, sign * on.apart};
  const Vec3 p_WP = p_WU + p_CT_W.dot(section.axis_W) * section.axis_W;
  return {p_WP, Status::Unique, sign * (p_WT - p_WP).norm()};
}

}  // namespace underact::shape
