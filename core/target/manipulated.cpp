#include "core/target/manipulated.h"

#include <algorithm>

namespace underact::target {

Target manipulatedTarget(const Constraint& constraint, const Pose& X_WT, double dt_s, manipulator::State& state,
                         Robot& robot) noexcept {
  const manipulator::Manipulator& manipulator = *constraint.manipulator;
  const manipulator::Followed followed = follow(manipulator, X_WT, dt_s, state);
  robot.joints = std::min(manipulator.chain.joints.size(), manipulator::kMaxJoints);
  robot.theta = followed.at.theta;
  robot.n_W = followed.at.tip.X_WT.linear().col(2);
  robot.moment_W = followed.moment_W;
  robot.f_along_T_W = followed.f_along_T_W;
  robot.energy_J = followed.at.energy_J;
  robot.left = followed.left;
  robot.steps = followed.steps;
  robot.slewing = followed.slewing;
  robot.better_J = followed.better_J;
  const double distance_m = (followed.p_WP - X_WT.translation()).norm();
  return {followed.p_WP, followed.is_unique ? Status::Unique : Status::Degenerate, distance_m};
}

}  // namespace underact::target
