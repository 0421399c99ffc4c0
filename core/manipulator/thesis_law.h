#pragma once
#include "core/manipulator/manipulator.h"

namespace underact::manipulator {

/// The force law of the thesis: besides kp (p_P - p_T) a force along the circle.
struct ThesisPull {
  double theta_rad = 0.0;           // the joint where its tip is nearest to the stylus
  double error_rad = 0.0;           // e_theta = theta - the stylus's own angle, in [-pi, pi]
  Vec3 p_WP = Vec3::Zero();         // nearest in the joint's plane
  Vec3 f_along_T_W = Vec3::Zero();  // -(ko e_theta / L) t, t the tangent
  Vec3 moment_W = Vec3::Zero();     // ko e_theta about the axis, N m; few arms render it
  bool is_unique = false;           // false: the stylus is on the axis
};

/// manipulator: of one revolute joint. The pivot is the joint's point, L the distance of the end effector from it. The
/// field is not conservative: its lever arm is L instead of r, and it does work on a loop; for comparison with the
/// energy's law. Source: Beckman 2007, code 5.2 and eq. 5.29, with their errata (pivot in theta_v, the wrap, the
/// pivot's own plane). Within 16 ulp of positions, of L and the angles times (largest coordinate / distance from the
/// axis); of the force, of ko times that over L.
ThesisPull thesisPull(const Manipulator& manipulator, const Pose& X_WT) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::manipulator
