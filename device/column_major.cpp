#include "device/column_major.h"

#include "core/base/units.h"

namespace underact::device {

Pose poseFrom(const ColumnMajor& T_mm) noexcept {
  const Eigen::Map<const Eigen::Matrix4d> T(T_mm.data());  // Eigen's own order
  Pose X_WT = Pose::Identity();
  X_WT.linear() = T.topLeftCorner<3, 3>();
  X_WT.translation() = kMetrePerMillimetre * T.topRightCorner<3, 1>();
  return X_WT;
}

ColumnMajor columnMajorFrom(const Pose& X_WT) noexcept {
  ColumnMajor T_mm{};
  Eigen::Map<Eigen::Matrix4d> T(T_mm.data());
  T = X_WT.matrix();
  T.topRightCorner<3, 1>() *= kMillimetrePerMetre;
  return T_mm;
}

}  // namespace underact::device
