#pragma once
#include "app/gui/model/numbered_solutions.h"
#include "core/arm/jacobian.h"

namespace underact::gui {

/// Everything that the kinematics panel shows for one instant.
struct KinematicsNow {
  arm::JointAngles q_rad{};
  arm::JointAngles device_rad{};  // of a device
  Pose X_WT = Pose::Identity();
  chain::Jacobian J;  // a column for each joint
  Mat3 J_p = Mat3::Zero();
  arm::Dexterity dexterity;
  arm::SingularityDistances distances;
  NumberedSolutions solutions;  // of X_WT
};

/// finder: of the same arm.
KinematicsNow kinematicsNow(const arm::Preset& preset, const SolutionFinder& finder, const arm::JointAngles& q);

// Below these limits a singularity counts as near. Shoulder: the tip then moves less than 20 mm per rad of joint 1,
// where statics.h begins to damp. Elbow and wrist: 1 / sin(15 degrees) is about four, so a joint turns about four times
// as fast as in the middle for the same motion. The limits are chosen, not measured.
inline constexpr double kNearShoulder_m = 0.020;
inline constexpr double kNearElbow_deg = 15.0;
inline constexpr double kNearWrist_deg = 15.0;

/// Force ellipsoid: of the Omni the forces for this torque; of any other arm for one that takes the same share of its
/// force and reach, with 1, 2 or 5 as its only digit.
inline constexpr double kOmniTorque_N_m = 0.05;
double ellipsoidTorque_N_m(const arm::Preset& preset, const arm::Model& model);

}  // namespace underact::gui
