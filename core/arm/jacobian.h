#pragma once
#include "core/arm/preset.h"
#include "core/base/real_time.h"
#include "core/base/types.h"
#include "core/chain/kinematics.h"

namespace underact::arm {

/// X_WT and the geometric Jacobian at the tip, rows v (m/rad) then w (rad/rad), in W: a column for each joint.
using chain::Kinematics;
/// What of it is asked for, beside the tip's position. A chain gives all of it. Lengths leave the orientation the
/// identity where it is not asked for, and give the columns of J of joints 1 to 3, which alone move the tip.
struct Parts {
  bool orientation = true, jacobian = true;
};
/// From one set of sines. Within 8 ulp of the reach (of 1 for the orientation) times the largest angle, 1 rad at least,
/// and 8 ulp of p_WB; by a chain as chain::kinematics(). Not finite in, not finite out. Source: Beckman 2007, eq. 3.1,
/// 3.5 and 3.6 (errata 3.5, 3.6), J their derivative, w by the axes of the joints; det J = det J_p times plus or minus
/// sin q5.
Kinematics kinematics(const Geometry& geometry, const JointAngles& q_rad,
                      const Parts& parts = {}) noexcept UNDERACT_REAL_TIME;

/// p_WT, m, and J_p, m/rad: the columns of v of the first three watched joints.
struct Tip {
  Vec3 p_WT = Vec3::Zero();
  Mat3 J_p = Mat3::Zero();
};
/// Of kinematics().
Tip tip(const Geometry& geometry, const JointAngles& q_rad) noexcept UNDERACT_REAL_TIME;
/// J_p of tip().
Mat3 positionJacobian(const Geometry& geometry, const JointAngles& q_rad) noexcept UNDERACT_REAL_TIME;

/// The image of a ball of joint rates under J_p: axes_W its principal directions in W (columns, right-handed), gain_m
/// the displacement of the tip along each per rad, largest first. A ball of joint torques maps to forces along the same
/// axes, with the factors 1 / gain.
struct Dexterity {
  Mat3 J = Mat3::Zero();  // J_p itself
  Mat3 axes_W = Mat3::Identity();
  Vec3 gain_m = Vec3::Zero();      // singular values
  double det_m3 = 0.0;             // L1 L2 cos q3 (L1 cos q2 + L2 sin(q2 + q3)); errata section 2
  double manipulability_m3 = 0.0;  // Yoshikawa's, |det|
  double condition = 0.0;          // largest over smallest gain; infinite where singular
};
/// In closed form, of an arm that solvesInTick(): column 1 is at right angles to the other two, which lie in the plane
/// of the arm.
Dexterity dexterity(const Geometry& geometry, const JointAngles& q_rad) noexcept UNDERACT_REAL_TIME;
/// The ellipsoid of any arm: by a chain for its driven joints, as many as they are; J has the columns of the first
/// three watched ones, and det_m3 a sign only where there are three joints. Not for the servo thread.
Dexterity dexterityOf(const Geometry& geometry, const JointAngles& q_rad);

/// The distance from each singularity; 0 is on it.
struct SingularityDistances {
  double shoulder_m = 0.0;  // of the wrist centre from axis 1
  double elbow_rad = 0.0;   // of q3 from +-90 degrees, stretched or folded
  double wrist_rad = 0.0;   // of q5 from 0 or pi
};
/// Each is 0 or above; not a number of an arm that does not solvesInTick(). From q1 to q3 and q5; joint limits do not
/// matter. Not finite in, not finite out.
SingularityDistances singularityDistances(const Geometry& geometry,
                                          const JointAngles& q_rad) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::arm
