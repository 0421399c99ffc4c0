#pragma once
#include "core/base/types.h"

namespace underact {

// Eigen's decompositions take five to fifteen seconds to compile wherever they are used; this room compiles them once.

/// Eigenvalues and eigenvectors of a symmetric matrix, in ascending order; each axis is a column, of length 1.
struct PrincipalAxes {
  Vec3 values;
  Mat3 axes;
};
/// symmetric: finite; its lower half is read. Iterative (Eigen's SelfAdjointEigenSolver).
PrincipalAxes principalAxes(const Mat3& symmetric);

/// Of any finite square matrix; conjugates are adjacent (Eigen's EigenSolver).
Eigen::VectorXcd eigenvaluesOf(const Eigen::MatrixXd& matrix);

/// The least-squares solution x (n x m) of A x = b for each column, of A (k x n, k >= n) and b (k x m), both finite
/// (Eigen's ColPivHouseholderQR). With linearly dependent columns of A, one of many.
Eigen::MatrixXd leastSquares(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b);

/// What leastSquares() leaves of b: b - A x.
Eigen::MatrixXd leastSquaresRest(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b);

/// The solution x of A x = b, of a symmetric A (n x n) that is not indefinite, whose lower half is read, and b (n x m),
/// both finite (Eigen's LDLT). Where A is singular, pivots of 0 contribute nothing to x.
Eigen::MatrixXd solveSymmetric(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b);

}  // namespace underact
