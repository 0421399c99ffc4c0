#pragma once
#include <array>
#include <vector>

#include "core/arm/preset.h"
#include "tests/error_bounds/oracle/turns.h"

namespace underact::error_bounds::oracle {

/// The arm by the six rows of its DH table, as a product of screws; the code under test does not multiply them.
struct ArmPose {
  Columns R_WT;
  Real3 p_WT;
};
/// The pose of the tip in W for joint angles in rad. Source: thesis table 3.1 as the errata correct it, and eq. 3.1.
ArmPose armPose(const arm::Geometry& geometry, const std::array<Real, 6>& q);

/// The doubles, exactly.
std::array<Real, 6> realOf(const arm::JointAngles& q_rad);

/// The columns of J_p, by difference quotients whose truncation error is below 50 digits.
std::array<Real3, 3> armJacobian(const arm::Geometry& geometry, const arm::JointAngles& q_rad);
/// The rotation of the stylus by each of the six joints: a rotation vector per radian.
std::array<Real3, 6> armTurning(const arm::Geometry& geometry, const arm::JointAngles& q_rad);

/// The solution of a 3 x 3 system by Cramer's rule.
Real3 solved(const std::array<Real3, 3>& columns, const Real3& right);

}  // namespace underact::error_bounds::oracle
