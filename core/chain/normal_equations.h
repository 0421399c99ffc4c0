#pragma once
#include <cstdint>

#include "core/chain/kinematics.h"

namespace underact::chain {

/// The error of a pose, in W: position, m, above the rotation vector times a length, m.
using Residual = Eigen::Matrix<double, 6, 1>;
/// A change of each joint, rad or m; what is beyond the chain's joints is not read.
using JointStep = Eigen::Matrix<double, static_cast<int>(kMaxJoints), 1>;

/// The damped least-squares step: dq that minimises |e - J dq|^2 + damping |dq|^2; columns whose bit is set in held are
/// left out. rows: 6, or 3 for the position alone. False where rounding leaves no positive pivot: more damping is
/// needed. Solves n x n where joints are few, J J^T where they outnumber the rows. Cost: some hundred multiplications.
bool dampedStep(const Jacobian& J, const Residual& e, std::size_t rows, double damping, std::uint32_t held,
                JointStep& dq) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::chain
