#include "core/base/eigenvalues.h"

#include <Eigen/Eigenvalues>

namespace underact {

PrincipalAxes principalAxes(const Mat3& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXcd eigenvaluesOf(const Eigen::MatrixXd& matrix) {
  return matrix.eigenvalues();
}

}  // namespace underact
