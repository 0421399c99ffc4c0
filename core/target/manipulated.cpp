#include "core/target/manipulated.h"

#include <algorithm>

namespace underact::target {

Target manipulatedTarget(const manipulator::Manipulator& manipulator, const Vec3& p_WT, const Mat3& R_WT, double dt_s,
                         manipulator::State& state, Robot& robot) noexcept {
  Pose X_WT = Pose::Identity();
  X_WT.linear() = R_WT;
  X_WT.translation() = p_WT;
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
  const double distance_m = (followed.p_WP - p_WT).norm();
  return {followed.p_WP, followed.is_unique ? Status::Unique : Status::Degenerate, distance_m};
}

}  // namespace underact::target
