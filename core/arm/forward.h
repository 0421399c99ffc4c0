#pragma once
#include "core/arm/preset.h"
#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::arm {

// Of an arm of another form (geometry.general) as chain::forward() says, from as many joints as it has.

/// p_WT, m, from the first three joints: the wrist's axes meet in the tip, so the wrist is not computed.
/// Source: Beckman 2007, eq. 3.1 and 3.5 (erratum 3.5: L1, L2 for a_2, d_4). Not finite in, not finite out.
Vec3 tipPosition(const Geometry& geometry, const JointAngles& q_rad) noexcept UNDERACT_REAL_TIME;

/// X_WT from all six joints. Within 8 ulp of the reach (of 1 for the orientation) times the largest angle, 1 rad at
/// least, and 8 ulp of p_WB; tipPosition() too. Source: eq. 3.5 and 3.6 (erratum 3.6), R_06 = R_03(q1, q2, q3) Rz(q4)
/// Ry(q5) Rz(q6).
Pose tipPose(const Geometry& geometry, const JointAngles& q_rad) noexcept UNDERACT_REAL_TIME;

/// The positions of shoulder, elbow and tip in W, m: what a drawing of the arm needs. Of an arm of another form, its
/// first and its middle joint and the tip.
struct Skeleton {
  Vec3 p_WShoulder;
  Vec3 p_WElbow;
  Vec3 p_WTip;
};
/// From joints 1 to 3. Not finite in, not finite out. Source: Beckman 2007, eq. 3.1 and 3.5 (erratum 3.5).
Skeleton skeleton(const Geometry& geometry, const JointAngles& q_rad) noexcept;

/// R_WB: x_W = y_B, y_W = z_B, z_W = x_B (eq. 3.1).
Mat3 workspaceFromBase() noexcept UNDERACT_REAL_TIME;

/// R_B3, frame 3 including the twist of joint 4 (alpha_3 = 90 degrees), so that R_B6 = R_B3 Rz(q4) Ry(q5) Rz(q6).
Mat3 baseFromForearm(const JointAngles& q_rad) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::arm
