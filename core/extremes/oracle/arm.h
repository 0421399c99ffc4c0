#pragma once
#include <array>
#include <vector>

#include "core/arm/preset.h"
#include "core/extremes/oracle/turns.h"

namespace underact::extremes::oracle {

/// The arm by the six rows of its DH table, one screw after the other; the code multiplies nothing of the kind out.
struct ArmPose {
  Columns R_WT;
  Real3 p_WT;
};
/// The pose of the tip in W for joint angles in rad. Source: thesis table 3.1 as the errata correct it, and eq. 3.1.
ArmPose armPose(const arm::Geometry& geometry, const std::array<Real, 6>& q);

/// The doubles, exactly.
std::array<Real, 6> realOf(const arm::JointAngles& q_rad);

/// How the tip moves by each of joints 1 to 3, by differences so small that what they leave out is below 50 digits.
std::array<Real3, 3> armJacobian(const arm::Geometry& geometry, const arm::JointAngles& q_rad);
/// How the stylus turns by each of the six joints: a rotation vector a radian.
std::array<Real3, 6> armTurning(const arm::Geometry& geometry, const arm::JointAngles& q_rad);

/// A 3 x 3 system by Cramer's rule.
Real3 solved(const std::array<Real3, 3>& columns, const Real3& right);

}  // namespace underact::extremes::oracle
