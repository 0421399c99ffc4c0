#pragma once
#include <vector>

#include "core/arm/branches.h"
#include "core/arm/jacobian.h"
#include "core/arm/model.h"
#include "core/chain/inverse.h"

namespace underact::gui {

/// An inverse solution of an arm that is not of the Omni's form: a value for each joint, rad or m.
struct ChainSolution {
  std::vector<double> q;
  bool within_limits = false;
};

/// Everything that the kinematics panel shows for one instant.
struct KinematicsNow {
  arm::JointAngles q_rad{};
  arm::JointAngles device_rad{};
  Pose X_WT = Pose::Identity();
  chain::Jacobian J;  // a column for each joint
  Mat3 J_p = Mat3::Zero();
  arm::Dexterity dexterity;
  arm::SingularityDistances distances;
  arm::Solutions solutions;             // of X_WT; of an arm of the Omni's form
  std::vector<ChainSolution> of_chain;  // the same of another arm that has a closed form
};

KinematicsNow kinematicsNow(const arm::Geometry& geometry, const arm::JointLimits& limits,
                            const arm::JointAngles& q_rad);
/// The same of an arm that is not of the Omni's form: neither device angles nor named singularities. inverse: of the
/// model's chain.
KinematicsNow kinematicsNow(const arm::Preset& preset, const arm::Model& model, const chain::Inverse& inverse,
                            const arm::JointAngles& q);

/// 1 to 8, the number of a solution in the panel and in the view: ordered by shoulder, elbow, wrist, + before -.
int numberOf(const arm::Branch& branch);
/// number: 1 to 8.
arm::Branch branchOf(int number);

// Below these limits a singularity counts as near. Shoulder: the tip then moves less than 20 mm per rad of joint 1,
// where statics.h begins to damp. Elbow and wrist: 1 / sin(15 degrees) is about four, so a joint turns about four times
// as fast as in the middle for the same motion. The limits are chosen, not measured.
inline constexpr double kNearShoulder_m = 0.020;
inline constexpr double kNearElbow_deg = 15.0;
inline constexpr double kNearWrist_deg = 15.0;

}  // namespace underact::gui
