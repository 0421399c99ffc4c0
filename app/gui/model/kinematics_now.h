#pragma once
#include "core/arm/branches.h"
#include "core/arm/jacobian.h"

namespace underact::gui {

/// All that the kinematics panel shows of one moment.
struct KinematicsNow {
  arm::JointAngles q_rad{};
  arm::JointAngles device_rad{};
  arm::Kinematics kinematics;  // X_WT and the 6 x 6 Jacobian
  Mat3 J_p = Mat3::Zero();
  arm::Dexterity dexterity;
  arm::SingularityDistances distances;
  arm::Solutions solutions;  // of X_WT
};

KinematicsNow kinematicsNow(const arm::Geometry& geometry, const arm::JointLimits& limits,
                            const arm::JointAngles& q_rad);

/// 1 to 8, as the panel's rows and the view's ghosts are called: in the order shoulder, elbow, wrist, + before -.
int numberOf(const arm::Branch& branch);
/// number: 1 to 8.
arm::Branch branchOf(int number);

// Under these a singularity counts as near. Shoulder: the tip then goes less than 20 mm for each rad of joint 1, where
// statics.h begins to damp. Elbow and wrist: one over the sine of 15 degrees is four; so many times faster than in the
// middle a joint turns for the same motion. They are chosen, not measured.
inline constexpr double kNearShoulder_m = 0.020;
inline constexpr double kNearElbow_deg = 15.0;
inline constexpr double kNearWrist_deg = 15.0;

}  // namespace underact::gui
