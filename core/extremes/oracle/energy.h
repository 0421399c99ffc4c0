#pragma once
#include <vector>

#include "core/extremes/oracle/chain.h"
#include "core/manipulator/manipulator.h"

namespace underact::extremes::oracle {

/// The energy of a manipulator against a stylus: V = 1/2 e^T K e + springs. Orientation None, Axis and Full.
Real energyOf(const manipulator::Manipulator& manipulator, const Pose& X_WT, const std::vector<Real>& theta);

/// dV/dtheta_i, by differences (see armJacobian()).
Real slopeOf(const manipulator::Manipulator& manipulator, const Pose& X_WT, std::vector<Real> theta, std::size_t joint);
/// d2V/dtheta_i2, the same.
Real bendOf(const manipulator::Manipulator& manipulator, const Pose& X_WT, std::vector<Real> theta, std::size_t joint);

}  // namespace underact::extremes::oracle
