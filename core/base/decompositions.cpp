#include "core/base/decompositions.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace underact {

PrincipalAxes principalAxes(const Mat3& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXcd eigenvaluesOf(const Eigen::MatrixXd& matrix) {
  return matrix.eigenvalues();
}

Eigen::MatrixXd leastSquares(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b) {
  return A.colPivHouseholderQr().solve(b);
}

Eigen::MatrixXd leastSquaresRest(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b) {
  return b - A * leastSquares(A, b);
}

Eigen::MatrixXd solveSymmetric(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b) {
  return A.ldlt().solve(b);
}

}  // namespace underact
