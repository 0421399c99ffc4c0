#pragma once
#include <array>
#include <vector>

#include "core/kinematics/solved_arm.h"

namespace underact::kinematics {

/// What the joints do for a wrench at the tip. Torques in N mm, N where the joint slides.
struct Statics {
  std::vector<double> torque;        // tau = J^T F
  std::vector<double> holding;       // what holds the arm's own weight; empty: its file has no masses
  std::array<double, 3> gains_mm{};  // of the tip's velocities by the driven joints, largest first
  Mat3 axes_W = Mat3::Identity();    // a row for each gain; forces have the same axes, and 1 / gain
};

/// q: rad, m where the joint slides. The wrench of the arm on its surroundings: N, N mm, in W. The weight acts along -y
/// of a haptic arm's workspace, and along -z of another robot's. Allocates.
Statics staticsOf(const SolvedArm& arm, const chain::JointValues& q, const Vec3& f_N, const Vec3& moment_N_mm);

/// Which joints have a motor, in order.
std::vector<bool> drivenOf(const SolvedArm& arm);

}  // namespace underact::kinematics
