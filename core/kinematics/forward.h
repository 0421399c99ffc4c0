#pragma once
#include <string>
#include <vector>

#include "core/kinematics/solved_arm.h"

namespace underact::kinematics {

// q: rad, m where the joint slides, as jointsOf() gives them; the answers are in mm.

/// X_WT, the translation in mm.
Eigen::Matrix4d poseOf(const SolvedArm& arm, const chain::JointValues& q) noexcept;

/// The Jacobian, 6 x joints: v in mm/rad (1 where the joint slides) above w (rad/rad, rad/mm), in W; of six joints that
/// all turn at the origin of frame 6, else at the tip. Allocates.
Eigen::MatrixXd jacobianOf(const SolvedArm& arm, const chain::JointValues& q);

/// How well the tip moves.
struct Dexterity {
  double det_mm3 = 0.0;  // of the block of joints 1 to 3; not a number of an arm that has not six joints that turn
  double manipulability = 0.0;        // Yoshikawa's measure of the position; mm to the power of at most three
  double condition = 0.0;             // largest over smallest gain; not a number where singular
  std::vector<const char*> singular;  // "shoulder", "elbow", "wrist" of the Omni's form; "position", "wrist" of others
};
/// Allocates.
Dexterity dexterityOf(const SolvedArm& arm, const chain::JointValues& q);

/// Whether the arm has six joints that all turn.
bool sixTurn(const SolvedArm& arm) noexcept;

}  // namespace underact::kinematics
