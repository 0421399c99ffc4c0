#pragma once
#include <span>
#include <vector>

#include "core/arm/model.h"

namespace underact::arm {

/// The torques, N m (forces, N, where a joint slides), with which the motors hold the arm's own weight at q (rad or m):
/// -sum over the links of m J_C^T g. gravity_W: m/s^2, as (0, 0, -9.80665) where z is up. Empty: the file has no
/// masses.
std::vector<double> holdingTorques(const Model& model, std::span<const double> q, const Vec3& gravity_W);

}  // namespace underact::arm
