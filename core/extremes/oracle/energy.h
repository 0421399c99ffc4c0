#pragma once
#include <vector>

#include "core/extremes/oracle/chain.h"
#include "core/manipulator/manipulator.h"

namespace underact::extremes::oracle {

/// How far `to` is turned from `from` about an axis, in (-pi, pi]: by their parts across it.
Real turnAbout(const Real3& axis, const Real3& from, const Real3& to);
/// How much a stylus's angle about an axis counts: smoothly from 0 on the axis to 1 at 5 degrees off it.
Real weightAbout(const Real3& axis, const Real3& stylus);

/// The energy of a manipulator against a stylus: V = 1/2 e^T K e + springs. Of Angle, where the tip points as it does,
/// not by the joint's value.
Real energyOf(const manipulator::Manipulator& manipulator, const Pose& X_WT, const std::vector<Real>& theta);

/// dV/dtheta_i, by differences (see armJacobian()).
Real slopeOf(const manipulator::Manipulator& manipulator, const Pose& X_WT, std::vector<Real> theta, std::size_t joint);

}  // namespace underact::extremes::oracle
