#pragma once
#include "core/arm/preset.h"
#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::arm {

/// p_WT, m, of kinematics(), without its other parts.
Vec3 tipPosition(const Geometry& geometry, const JointAngles& q_rad) noexcept UNDERACT_REAL_TIME;

/// X_WT of kinematics(), without the Jacobian.
Pose tipPose(const Geometry& geometry, const JointAngles& q_rad) noexcept UNDERACT_REAL_TIME;

/// The middle of its workspace, m, around which scenes and hands are made: the origin of W where it solvesInTick(),
/// else the tip at its rest.
Vec3 workspaceMiddle(const Geometry& geometry) noexcept UNDERACT_REAL_TIME;

/// The positions of shoulder, elbow and tip in W, m: what a drawing of the arm needs. By a chain, those of its first
/// and its middle joint and the tip.
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
