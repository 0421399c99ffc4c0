#pragma once
#include "core/base/types.h"

namespace underact {

// Compiled once, as the other decompositions (decompositions.h).

/// Singular values, the largest first, and as columns the vectors of one side, an orthonormal basis of its whole space.
struct SingularValues {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
/// A (m x n): of any size but 0, finite. vectors: U (m x m), of the image (Eigen's JacobiSVD).
SingularValues leftSingularValues(const Eigen::MatrixXd& A);
/// As above. vectors: V (n x n), of the arguments.
SingularValues rightSingularValues(const Eigen::MatrixXd& A);

/// The principal half axes of an ellipse, the longer first, their directions, and as third axis the normal of its
/// plane.
struct EllipseAxes {
  Eigen::Vector2d half_m;
  Mat3 axes;
};
/// pair: two conjugate half diameters, m, finite (Eigen's JacobiSVD).
EllipseAxes ellipseAxes(const Eigen::Matrix<double, 3, 2>& pair);

}  // namespace underact
