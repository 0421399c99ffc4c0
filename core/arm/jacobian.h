#pragma once
#include "core/arm/preset.h"
#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::arm {

/// J_p, 3x3, m/rad: v_WT = J_p (dq1, dq2, dq3)/dt, in W; joints 4 to 6 do not move the tip. Source: derivative of eq.
/// 3.5.
/// Of an arm of another form (geometry.general): the columns of its watched joints.
Mat3 positionJacobian(const Geometry& geometry, const JointAngles& q_rad) noexcept UNDERACT_REAL_TIME;

/// p_WT and J_p from one set of sines.
struct Tip {
  Vec3 p_WT = Vec3::Zero();
  Mat3 J_p = Mat3::Zero();
};
/// From joints 1 to 3. Not finite in, not finite out. Source: as tipPosition() and positionJacobian().
Tip tip(const Geometry& geometry, const JointAngles& q_rad) noexcept UNDERACT_REAL_TIME;

/// X_WT and the geometric Jacobian at the origin of frame 6, rows v (m/rad) then w (rad/rad), in W, from one set of
/// sines. det J = det J_p times plus or minus sin q5.
struct Kinematics {
  Pose X_WT = Pose::Identity();
  Mat6 J = Mat6::Zero();
};
/// Not finite in, not finite out. Source: eq. 3.5 and 3.6 (errata 3.5, 3.6); w by the axes of the joints. Of an arm of
/// another form, at its tip; columns beyond its joints are 0.
Kinematics kinematics(const Geometry& geometry, const JointAngles& q_rad) noexcept UNDERACT_REAL_TIME;

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
/// In closed form: column 1 is at right angles to the other two, which lie in the plane of the arm. Not of an arm of
/// another form.
Dexterity dexterity(const Geometry& geometry, const JointAngles& q_rad) noexcept UNDERACT_REAL_TIME;
/// The ellipsoid of an arm of any form: of another one for its driven joints, as many as they are; J has the columns of
/// the watched ones, and det_m3 a sign only where there are three joints. Not for the servo thread.
Dexterity dexterityOf(const Geometry& geometry, const JointAngles& q_rad);

/// The distance from each singularity; 0 is on it.
struct SingularityDistances {
  double shoulder_m = 0.0;  // of the wrist centre from axis 1
  double elbow_rad = 0.0;   // of q3 from +-90 degrees, stretched or folded
  double wrist_rad = 0.0;   // of q5 from 0 or pi
};
/// Each is 0 or above; not a number of an arm of another form. From q1 to q3 and q5; joint limits do not matter. Not
/// finite in, not finite out.
SingularityDistances singularityDistances(const Geometry& geometry,
                                          const JointAngles& q_rad) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::arm
