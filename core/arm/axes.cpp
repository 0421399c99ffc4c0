#include "core/arm/axes.h"

namespace underact::arm {

Plane planeOf(const Geometry& geometry, const JointAngles& q_rad) noexcept {
  const auto [turret, thigh] = sinCosOfTwo(q_rad[0], q_rad[1]);
  const SinCos shin = sinCosOfTwo(q_rad[1] + q_rad[2], 0.0).first;
  const double upper = geometry.upper_m, fore = geometry.fore_m;
  return {
      turret,          thigh,          shin, upper * thigh.cos + fore * shin.sin, upper * thigh.sin - fore * shin.cos,
      fore * shin.cos, fore * shin.sin};
}

Axes axesOf(const Plane& plane, const JointAngles& q_rad) noexcept {
  const auto [four, five] = sinCosOfTwo(q_rad[3], q_rad[4]);
  const SinCos six = sinCosOfTwo(q_rad[5], 0.0).first;
  const double c1 = plane.turret.cos, s1 = plane.turret.sin;
  // x_W = y_B, y_W = z_B, z_W = x_B (eq. 3.1).
  const Vec3 across_W(s1 * plane.shin.cos, plane.shin.sin, c1 * plane.shin.cos);  // frame 3's x, including the twist
  Axes axes;
  axes.along_W = Vec3(s1 * plane.shin.sin, -plane.shin.cos, c1 * plane.shin.sin);
  axes.side_W = Vec3(-c1, 0.0, s1);
  axes.five_W = four.cos * axes.side_W - four.sin * across_W;
  const Vec3 x4_W = four.cos * across_W + four.sin * axes.side_W;
  const Vec3 x5_W = five.cos * x4_W - five.sin * axes.along_W;
  axes.R_WT.col(0) = six.cos * x5_W + six.sin * axes.five_W;
  axes.R_WT.col(1) = six.cos * axes.five_W - six.sin * x5_W;
  axes.R_WT.col(2) = five.sin * x4_W + five.cos * axes.along_W;
  return axes;
}

}  // namespace underact::arm
