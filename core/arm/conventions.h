#pragma once
#include "core/arm/sample.h"
#include "core/base/real_time.h"

namespace underact::arm {

/// The device's own angles (turret, thigh, shin; gimbal 1 to 3), rad, and the DH angles. The shin is measured from the
/// base. Source: Beckman 2007, figure 3.5: q1 = -q1p, q2 = q2p, q3 = q3p - q2p; the gimbal: q4 = -g1, q5 = g2 + pi/2,
/// q6 = -g3 - pi/2, which reproduces a public recording. The signs on hardware are not verified.
JointAngles dhFromDevice(const JointAngles& device_rad) noexcept UNDERACT_REAL_TIME;
JointAngles deviceFromDh(const JointAngles& q_rad) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::arm
