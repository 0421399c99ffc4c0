#pragma once
#include <span>
#include <vector>

#include "core/chain/kinematics.h"

namespace underact::chain {

/// The image of a ball under a Jacobian of the position: as many principal axes as there are directions in which the
/// tip can move, at most three. Of joint rates: gains are the tip's displacement, m per rad (per m, where a joint
/// slides); of joint torques (or forces): the force at the tip along the same axes is 1 / gain.
struct Ellipsoid {
  std::array<double, 3> gain{};  // largest first; 0 in directions that are lost
  std::array<Vec3, 3> axis_W{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};  // unit, at right angles
  double manipulability = 0.0;   // the product of those that the joints could have: Yoshikawa's measure
  double condition = kInfinity;  // largest over smallest of them
};

/// Of the joints for which driven is true; joints beyond it are. Not finite in: no axis is told. Not for the servo
/// thread. Source: Yoshikawa 1985.
Ellipsoid positionEllipsoid(const Jacobian& J, const std::vector<bool>& driven);

/// The torques of the joints, N m (or forces, N, where they slide), for a wrench of the arm on its surroundings at the
/// tip, in W (force, N; moment, N m): tau = J^T F. Of each column of J.
std::vector<double> torquesOf(const Jacobian& J, const Vec6& wrench_T_W);

}  // namespace underact::chain
