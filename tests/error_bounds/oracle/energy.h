#pragma once
#include <vector>

#include "core/manipulator/manipulator.h"
#include "tests/error_bounds/oracle/chain.h"

namespace underact::error_bounds::oracle {

/// The angle from `from` to `to` about an axis, in (-pi, pi], of their parts at right angles to it.
Real turnAbout(const Real3& axis, const Real3& from, const Real3& to);
/// The weight of a stylus's angle about an axis: smoothly from 0 on the axis to 1 at 5 degrees off it.
Real weightAbout(const Real3& axis, const Real3& stylus);

/// The energy of a manipulator with a stylus: V = 1/2 e^T K e + springs. For Angle, by the direction of the tip, not by
/// the joint's value.
Real energyOf(const manipulator::Manipulator& manipulator, const Pose& X_WT, const std::vector<Real>& theta);

/// dV/dtheta_i, by difference quotients (see armJacobian()).
Real slopeOf(const manipulator::Manipulator& manipulator, const Pose& X_WT, std::vector<Real> theta, std::size_t joint);

}  // namespace underact::error_bounds::oracle
