#pragma once
#include "core/manipulator/follow.h"
#include "core/target/target.h"

namespace underact::target {

/// The result of a virtual robot in a tick.
struct Robot {
  std::size_t joints = 0;           // 0: the constraint is none
  manipulator::Values theta{};      // rad or m
  Vec3 n_W = Vec3::Zero();          // z of its tip V
  Vec3 moment_W = Vec3::Zero();     // the moment of the force, N m; few arms render it
  Vec3 f_along_T_W = Vec3::Zero();  // the thesis's law: what it adds to the control's force
  double energy_J = 0.0;
  double left = 0.0;  // see manipulator::Followed
  int steps = 0;
  bool slewing = false;
  double better_J = 0.0;  // what another known minimum would save
};

/// The target that is the end effector of a virtual robot, and the robot. dt_s: since the last tick, 0: unknown.
Target manipulatedTarget(const manipulator::Manipulator& manipulator, const Vec3& p_WT, const Mat3& R_WT, double dt_s,
                         manipulator::State& state, Robot& robot) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::target
