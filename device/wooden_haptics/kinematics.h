#pragma once
#include "core/arm/sample.h"
#include "core/base/real_time.h"
#include "device/wooden_haptics/models.h"

namespace underact::device {

/// Joints 1 to 3 of the arm, as an Omni with the lengths of woodenGeometry(); 4 to 6, which it does not have, are 0.
/// Angles A of the foot, B and C of upper arm and forearm from the vertical: q1 = A, q2 = pi/2 - B, q3 = B + C - pi/2,
/// with which eq. 3.5 of the thesis is the source's x = cos A (Lb sin B + Lc sin C), z = La + Lb cos B - Lc cos C.
/// Source: haptikfabrikenapi, kinematics.cpp. Finite for all counts.
arm::JointAngles woodenJoints(const WoodenModel& model, const WoodenWiring& wiring,
                              const std::array<int, 3>& counts) noexcept UNDERACT_REAL_TIME;

/// Whether an arm can be in that configuration: joints 1 to 3 lie within the limits of the preset "woodenhaptics".
bool isWoodenPosture(const arm::JointAngles& q_rad);

/// The currents for the force f_T_W, N, on the tip: torques by the transposed Jacobian, through capstans and torque
/// constants, to the nearest mA. If a motor would need more than kMaxCurrent_mA, all are scaled down alike, so that
/// the force keeps its direction. For a force that is not finite: 0.
Currents_mA woodenCurrents(const WoodenModel& model, const WoodenWiring& wiring, const arm::JointAngles& q_rad,
                           const Vec3& f_T_W) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::device
