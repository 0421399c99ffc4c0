#pragma once
#include "core/base/real_time.h"
#include "core/base/trig.h"
#include "core/base/types.h"

namespace underact::arm {

// Inside the room: the wrist of every inverse kinematics.

/// R_B3, frame 3 including the twist of joint 4, from the sines of q1 and of q2 + q3.
Mat3 forearmRotation(const SinCos& turret, const SinCos& shin) noexcept UNDERACT_REAL_TIME;

/// Joints 4 to 6 with q5 >= 0; the other solution has q4 and q6 half a turn further and -q5.
struct Wrist {
  double q4_rad = 0.0, q5_rad = 0.0, q6_rad = 0.0;
  double bend_sin = 0.0;  // of q5; small where axes 4 and 6 are in line
  bool ahead = true;      // in line: axis 6 points along axis 4, not against it
};
/// R_36: R_B3^T R_BT = Rz(q4) Ry(q5) Rz(q6). In line, q4 is 0 and q6 takes all of q4 + q6 (or q6 - q4).
/// Source: Beckman 2007, eq. 3.17-3.20 as errata section 2 corrects them; joint 6 differs from eq. 3.20, see there.
Wrist wristOf(const Mat3& R_36) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::arm
