#include "core/arm/jacobian.h"

#include <algorithm>
#include <cmath>

#include "core/base/trig.h"
#include "core/base/units.h"

namespace underact::arm {
namespace {

/// The arm in its own plane, and how joints 2 and 3 move the tip there.
struct Plane {
  SinCos turret, thigh, shin;  // of q1, q2, q2 + q3
  double out_m, up_m;          // the tip from axis 1 and above the shoulder, eq. 3.5
  double out_3_m, up_3_m;      // by joint 3; by joint 2: -up_m, out_m
};

Plane planeOf(const Geometry& geometry, const JointAngles& q_rad) noexcept UNDERACT_REAL_TIME {
  const auto [turret, thigh] = sinCosOfTwo(q_rad[0], q_rad[1]);
  const SinCos shin = sinCosOfTwo(q_rad[1] + q_rad[2], 0.0).first;
  const double upper = geometry.upper_m, fore = geometry.fore_m;
  return {
      turret,          thigh,          shin, upper * thigh.cos + fore * shin.sin, upper * thigh.sin - fore * shin.cos,
      fore * shin.cos, fore * shin.sin};
}

/// In W: x_W = y_B, y_W = z_B, z_W = x_B.
Mat3 positionJacobian(const Plane& at) noexcept UNDERACT_REAL_TIME {
  const double c1 = at.turret.cos, s1 = at.turret.sin;
  Mat3 J;
  J << c1 * at.out_m, -s1 * at.up_m, s1 * at.out_3_m,  //
      0.0, at.out_m, at.up_3_m,                        //
      -s1 * at.out_m, -c1 * at.up_m, c1 * at.out_3_m;
  return J;
}

/// One singular value decomposition of a 2x2 matrix M, of which only left vectors are asked.
struct Pair {
  double large, small;  // singular values
  SinCos direction;     // of the left vector of the large one
};

Pair decompose(double a, double b, double c, double d) noexcept UNDERACT_REAL_TIME {
  // M M^T = [p q; q r]; the large vector's angle is half of atan2(2 q, p - r).
  const double p = a * a + b * b, q = a * c + b * d, r = c * c + d * d;
  const double root = std::sqrt((p - r) * (p - r) + 4.0 * q * q);
  Pair result{};
  result.large = std::sqrt(0.5 * (p + r + root));
  // By the determinant: a difference of squares would lose the small one near a singularity.
  result.small = result.large > 0.0 ? std::abs(a * d - b * c) / result.large : 0.0;
  result.direction = sinCos(0.5 * atan2Of(2.0 * q, p - r));
  return result;
}

}  // namespace

Mat3 positionJacobian(const Geometry& geometry, const JointAngles& q_rad) noexcept {
  return positionJacobian(planeOf(geometry, q_rad));
}

Kinematics kinematics(const Geometry& geometry, const JointAngles& q_rad) noexcept {
  const Plane at = planeOf(geometry, q_rad);
  const auto [four, five] = sinCosOfTwo(q_rad[3], q_rad[4]);
  const SinCos six = sinCosOfTwo(q_rad[5], 0.0).first;
  const double c1 = at.turret.cos, s1 = at.turret.sin;
  // Axes in W: forearm across (frame 3's x with the twist taken in) and along, and joint 2's.
  const Vec3 across_W(s1 * at.shin.cos, at.shin.sin, c1 * at.shin.cos);
  const Vec3 along_W(s1 * at.shin.sin, -at.shin.cos, c1 * at.shin.sin);
  const Vec3 side_W(-c1, 0.0, s1);
  const Vec3 bent_W = four.cos * across_W + four.sin * side_W;  // x of frame 4
  const Vec3 five_W = four.cos * side_W - four.sin * across_W;  // axis 5
  const Vec3 x5_W = five.cos * bent_W - five.sin * along_W;
  const Vec3 six_W = five.sin * bent_W + five.cos * along_W;  // axis 6, the stylus

  Kinematics result;
  result.X_WT.linear().col(0) = six.cos * x5_W + six.sin * five_W;
  result.X_WT.linear().col(1) = six.cos * five_W - six.sin * x5_W;
  result.X_WT.linear().col(2) = six_W;
  result.X_WT.translation() = geometry.p_WB + Vec3(s1 * at.out_m, at.up_m, c1 * at.out_m);
  result.J.topLeftCorner<3, 3>() = positionJacobian(at);
  result.J.bottomRows<3>() << Vec3::UnitY(), side_W, side_W, along_W, five_W, six_W;
  return result;
}

Dexterity dexterity(const Geometry& geometry, const JointAngles& q_rad) noexcept {
  const Plane at = planeOf(geometry, q_rad);
  const Pair in_plane = decompose(-at.up_m, at.out_3_m, at.out_m, at.up_3_m);
  const Vec3 out_W(at.turret.sin, 0.0, at.turret.cos), around_W(at.turret.cos, 0.0, -at.turret.sin);
  const auto [s, c] = in_plane.direction;
  struct Axis {
    double gain_m;
    Vec3 axis_W;
  };
  std::array<Axis, 3> axes{Axis{std::abs(at.out_m), around_W}, Axis{in_plane.large, c * out_W + s * Vec3::UnitY()},
                           Axis{in_plane.small, c * Vec3::UnitY() - s * out_W}};
  const auto order = [&](std::size_t a, std::size_t b) {
    if (axes[a].gain_m < axes[b].gain_m) std::swap(axes[a], axes[b]);
  };
  order(0, 1), order(1, 2), order(0, 1);
  Dexterity result;
  result.J = positionJacobian(at);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.axes_W.col(static_cast<Eigen::Index>(axis)) = axes[axis].axis_W;
    result.gain_m[static_cast<Eigen::Index>(axis)] = axes[axis].gain_m;
  }
  if (result.axes_W.determinant() < 0.0) result.axes_W.col(2) = -result.axes_W.col(2);
  // up_m, out_3_m, ... reduce to L1 L2 cos q3; kept as they are, since their rounding is that of J_p.
  result.det_m3 = at.out_m * (at.out_m * at.out_3_m + at.up_m * at.up_3_m);
  result.manipulability_m3 = std::abs(result.det_m3);
  result.condition = result.gain_m[2] > 0.0 ? result.gain_m[0] / result.gain_m[2] : kInfinity;
  return result;
}

SingularityDistances singularityDistances(const Geometry& geometry, const JointAngles& q_rad) noexcept {
  const Plane at = planeOf(geometry, q_rad);
  const SinCos elbow = sinCos(q_rad[2]), wrist = sinCos(q_rad[4]);
  return {std::abs(at.out_m), atan2Of(std::abs(elbow.cos), std::abs(elbow.sin)),
          atan2Of(std::abs(wrist.sin), std::abs(wrist.cos))};
}

}  // namespace underact::arm
