#pragma once
#include "core/base/types.h"

namespace underact {

// Eigen's solvers take five to fifteen seconds to compile wherever they are used: here they are compiled once.

/// Of a symmetric matrix, rising; each axis is a column, of length 1.
struct PrincipalAxes {
  Vec3 values;
  Mat3 axes;
};
/// symmetric: finite; its lower half counts. By iteration (Eigen's SelfAdjointEigenSolver).
PrincipalAxes principalAxes(const Mat3& symmetric);

/// Of any square matrix that is finite; conjugates are side by side (Eigen's EigenSolver).
Eigen::VectorXcd eigenvaluesOf(const Eigen::MatrixXd& matrix);

}  // namespace underact
