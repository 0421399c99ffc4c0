#include "core/chain/statics.h"

#include "core/base/singular_values.h"

namespace underact::chain {

Ellipsoid positionEllipsoid(const Jacobian& J, const std::vector<bool>& driven) {
  Ellipsoid ellipsoid;
  Eigen::MatrixXd J_p = Eigen::MatrixXd::Zero(3, J.cols());
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < J.cols(); ++i) {
    const auto joint = static_cast<std::size_t>(i);
    if (joint >= driven.size() || driven[joint]) J_p.col(count++) = J.col(i).head<3>();
  }
  if (count == 0 || !J_p.allFinite()) return ellipsoid;
  const auto [gains, axes_W] = leftSingularValues(J_p.leftCols(count));
  ellipsoid.manipulability = 1.0;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    ellipsoid.axis_W[axis] = axes_W.col(i);
    if (i >= gains.size()) continue;
    ellipsoid.gain[axis] = gains[i];
    ellipsoid.manipulability *= gains[i];
  }
  const double min = gains[gains.size() - 1];
  if (min > 0.0) ellipsoid.condition = gains[0] / min;
  return ellipsoid;
}

std::vector<double> torquesOf(const Jacobian& J, const Vec6& wrench_T_W) {
  std::vector<double> torques;
  for (Eigen::Index i = 0; i < J.cols(); ++i) torques.push_back(J.col(i).dot(wrench_T_W));
  return torques;
}

}  // namespace underact::chain
