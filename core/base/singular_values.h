#pragma once
#include "core/base/types.h"

namespace underact {

// Compiled once, as the other decompositions (decompositions.h).

/// Singular values, the largest first, and as columns the vectors of one side, an orthonormal basis of its whole space.
struct SingularValues {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
/// A: of any size but 0, finite. vectors: of the image (U), or of the arguments (V) (Eigen's JacobiSVD).
SingularValues leftSingularValues(const Eigen::MatrixXd& A);
SingularValues rightSingularValues(const Eigen::MatrixXd& A);

/// The principal axes and half axes of an ellipse, the longer first, and as third axis the normal of its plane; pair:
/// two conjugate half diameters, finite (Eigen's JacobiSVD).
struct EllipseAxes {
  Eigen::Vector2d half_m;
  Mat3 axes;
};
EllipseAxes ellipseAxes(const Eigen::Matrix<double, 3, 2>& pair);

}  // namespace underact
