#include "core/base/singular_values.h"

#include <Eigen/SVD>

namespace underact {

SingularValues leftSingularValues(const Eigen::MatrixXd& A) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeFullU);
  return {svd.singularValues(), svd.matrixU()};
}

SingularValues rightSingularValues(const Eigen::MatrixXd& A) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeFullV);
  return {svd.singularValues(), svd.matrixV()};
}

EllipseAxes ellipseAxes(const Eigen::Matrix<double, 3, 2>& pair) {
  const Eigen::JacobiSVD<Eigen::Matrix<double, 3, 2>> svd(pair, Eigen::ComputeFullU);
  return {svd.singularValues(), svd.matrixU()};
}

}  // namespace underact
