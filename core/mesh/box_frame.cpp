#include "core/mesh/box_frame.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

namespace underact::mesh {
namespace {

/// More than the rounding of a float coordinate at a distance of the size of the box.
constexpr double kFrameWider = 4e-6;

/// Rows: the principal axes of the corners, that of the least spread last. The identity where there are none.
Mat3 spreadAxes(const std::vector<Eigen::Vector3f>& corners, const Vec3& mean) {
  Mat3 spread = Mat3::Zero();
  for (const Eigen::Vector3f& corner : corners) {
    const Vec3 v = corner.cast<double>() - mean;
    spread += v * v.transpose();
  }
  const double size = spread.trace();
  if (!(size > 0.0)) return Mat3::Identity();
  Eigen::SelfAdjointEigenSolver<Mat3> solver;
  solver.computeDirect(spread / size);
  const Vec3 longest = solver.eigenvectors().col(2);  // ascending as given
  const Vec3 across = solver.eigenvectors().col(1) - solver.eigenvectors().col(1).dot(longest) * longest;
  const bool is_frame = std::abs(longest.norm() - 1.0) < 0.1 && across.norm() > 0.1;
  if (!is_frame) return Mat3::Identity();
  Mat3 axes;
  axes.row(0) = longest.normalized();
  axes.row(1) = across.normalized();
  axes.row(2) = axes.row(0).cross(axes.row(1));
  return axes;
}

}  // namespace

void setBoxes(const std::vector<Eigen::Vector3f>& corners, const std::array<std::size_t, kChildren + 1>& begins,
              Node& node) {
  Vec3 mean = Vec3::Zero();
  for (const Eigen::Vector3f& corner : corners) mean += corner.cast<double>();
  mean /= static_cast<double>(corners.size());
  const Mat3 axes = spreadAxes(corners, mean);
  for (std::size_t row = 0; row < 3; ++row) {
    const auto r = static_cast<Eigen::Index>(row);
    node.p_MN[row] = static_cast<float>(mean[r]);
    for (std::size_t column = 0; column < 3; ++column)
      node.R_MN[3 * column + row] = static_cast<float>(axes(r, static_cast<Eigen::Index>(column)));
  }
  // As the node has them, after rounding.
  const Mat3 R_NM = Eigen::Map<const Eigen::Matrix3f>(node.R_MN.data()).cast<double>();  // a row there is a column here
  const Vec3 p_MN = Eigen::Map<const Eigen::Vector3f>(node.p_MN.data()).cast<double>();
  for (std::size_t child = 0; child < kChildren; ++child) {
    Vec3 low = Vec3::Constant(kInfinity), high = Vec3::Constant(-kInfinity);
    for (std::size_t k = begins[child]; k < begins[child + 1]; ++k) {
      const Vec3 p_N = R_NM * (corners[k].cast<double>() - p_MN);
      low = low.cwiseMin(p_N);
      high = high.cwiseMax(p_N);
    }
    const double wider = kFrameWider * std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      const bool is_empty = !(low[a] <= high[a]);
      node.low_N[axis][child] = is_empty ? std::numeric_limits<float>::infinity() : static_cast<float>(low[a] - wider);
      node.high_N[axis][child] =
          is_empty ? -std::numeric_limits<float>::infinity() : static_cast<float>(high[a] + wider);
    }
  }
}

}  // namespace underact::mesh
