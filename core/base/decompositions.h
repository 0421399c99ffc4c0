#pragma once
#include "core/base/types.h"

namespace underact {

// Eigen's decompositions take five to fifteen seconds to compile wherever they are used: here they are compiled once.

/// Of a symmetric matrix, rising; each axis is a column, of length 1.
struct PrincipalAxes {
  Vec3 values;
  Mat3 axes;
};
/// symmetric: finite; its lower half counts. By iteration (Eigen's SelfAdjointEigenSolver).
PrincipalAxes principalAxes(const Mat3& symmetric);

/// Of any square matrix that is finite; conjugates are side by side (Eigen's EigenSolver).
Eigen::VectorXcd eigenvaluesOf(const Eigen::MatrixXd& matrix);

/// The x (n x m) that makes each column of A x - b least, of A (k x n, k >= n) and b (k x m), both finite (Eigen's
/// ColPivHouseholderQR). Where the columns of A depend on each other, one of many.
Eigen::MatrixXd leastSquares(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b);

/// The x of A x = b, of a symmetric A (n x n) that is not indefinite, of which the lower half counts, and b (n x m),
/// both finite (Eigen's LDLT). Where A is singular, what it does not reach is left out of x.
Eigen::MatrixXd solveSymmetric(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b);

}  // namespace underact
