#include "core/arm/jacobian.h"

#include <algorithm>
#include <cmath>

#include "core/arm/axes.h"
#include "core/arm/mechanism.h"
#include "core/base/decompositions.h"
#include "core/base/trig.h"
#include "core/base/units.h"

namespace underact::arm {
namespace {

/// In W: x_W = y_B, y_W = z_B, z_W = x_B.
Mat3 positionJacobian(const Plane& at) noexcept UNDERACT_REAL_TIME {
  const double c1 = at.turret.cos, s1 = at.turret.sin;
  Mat3 J;
  J << c1 * at.out_m, -s1 * at.up_m, s1 * at.out_3_m,  //
      0.0, at.out_m, at.up_3_m,                        //
      -s1 * at.out_m, -c1 * at.up_m, c1 * at.out_3_m;
  return J;
}

/// The singular value decomposition of a 2x2 matrix M, with its left vectors alone.
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
  // By the determinant: a difference of squares would cancel near a singularity.
  result.small = result.large > 0.0 ? std::abs(a * d - b * c) / result.large : 0.0;
  result.direction = sinCos(0.5 * atan2Of(2.0 * q, p - r));
  return result;
}

}  // namespace

Kinematics kinematics(const Geometry& geometry, const JointAngles& q_rad, const Parts& parts) noexcept {
  if (geometry.by_chain) return chain::kinematics(geometry.mechanism->chain, q_rad);
  const Plane at = planeOf(geometry, q_rad);
  Kinematics result;
  result.X_WT.translation() = geometry.p_WB + Vec3(at.turret.sin * at.out_m, at.up_m, at.turret.cos * at.out_m);
  if (parts.jacobian) {
    result.J.resize(6, parts.orientation ? 6 : 3);
    result.J.topLeftCorner<3, 3>() = positionJacobian(at);
    const Vec3 side_W(-at.turret.cos, 0.0, at.turret.sin);
    result.J.bottomLeftCorner<3, 3>() << Vec3::UnitY(), side_W, side_W;
  }
  if (!parts.orientation) return result;
  const Axes axes = axesOf(at, q_rad);
  result.X_WT.linear() = axes.R_WT;
  if (!parts.jacobian) return result;
  result.J.topRightCorner<3, 3>().setZero();
  result.J.bottomRightCorner<3, 3>() << axes.along_W, axes.five_W, axes.R_WT.col(2);
  return result;
}

Tip tip(const Geometry& geometry, const JointAngles& q_rad) noexcept {
  const Kinematics at = kinematics(geometry, q_rad, {false, true});
  return {at.X_WT.translation(), watchedColumns(watchedJoints(geometry), at.J)};
}

Mat3 positionJacobian(const Geometry& geometry, const JointAngles& q_rad) noexcept {
  return tip(geometry, q_rad).J_p;
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

Dexterity dexterityOf(const Geometry& geometry, const JointAngles& q_rad) {
  if (solvesInTick(geometry)) return dexterity(geometry, q_rad);
  const Mechanism& arm = *geometry.mechanism;
  const chain::Jacobian J = chain::jacobian(arm.chain, q_rad);
  Mat3 square = Mat3::Zero();
  for (Eigen::Index joint = 0; joint < J.cols(); ++joint) {
    const Vec3 offset = J.col(joint).head<3>();
    if (arm.driven[static_cast<std::size_t>(joint)]) square += offset * offset.transpose();
  }
  Dexterity result;
  result.J = watchedColumns(watchedJoints(geometry), J);
  if (!square.allFinite()) return result;
  const PrincipalAxes principal = principalAxes(square);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    result.axes_W.col(axis) = principal.axes.col(2 - axis);
    result.gain_m[axis] = std::sqrt(std::max(0.0, principal.values[2 - axis]));
  }
  if (result.axes_W.determinant() < 0.0) result.axes_W.col(2) = -result.axes_W.col(2);
  result.manipulability_m3 = result.gain_m.prod();
  const double sign = result.J.determinant() < 0.0 && J.cols() == 3 ? -1.0 : 1.0;
  result.det_m3 = sign * result.manipulability_m3;
  result.condition = result.gain_m[2] > 0.0 ? result.gain_m[0] / result.gain_m[2] : kInfinity;
  return result;
}

SingularityDistances singularityDistances(const Geometry& geometry, const JointAngles& q_rad) noexcept {
  if (!solvesInTick(geometry)) return {kNotANumber, kNotANumber, kNotANumber};
  const Plane at = planeOf(geometry, q_rad);
  const SinCos elbow = sinCos(q_rad[2]), wrist = sinCos(q_rad[4]);
  return {std::abs(at.out_m), atan2Of(std::abs(elbow.cos), std::abs(elbow.sin)),
          atan2Of(std::abs(wrist.sin), std::abs(wrist.cos))};
}

}  // namespace underact::arm
