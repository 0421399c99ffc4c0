#include "core/base/rotation.h"

#include "core/base/trig.h"

namespace underact {

Vec3 rotationVector(const Mat3& R) noexcept {
  const Vec3 twice_sine(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
  const double twice_sin = twice_sine.norm(), twice_cos = R(0, 0) + R(1, 1) + R(2, 2) - 1.0;
  const double angle_rad = atan2Of(twice_sin, twice_cos);
  // Up to a third of a turn the sine determines the axis as well as the angle.
  if (twice_cos > -1.0) return (twice_sin > 0.0 ? angle_rad / twice_sin : 0.5) * twice_sine;
  // Near half a turn the sine cancels: R + R^T - 2 cos is 2 (1 - cos) axis axis^T, and its longest column is the most
  // accurate. The sine decides between the two axes.
  const Mat3 squared = 0.5 * (R + R.transpose()) - (0.5 * twice_cos) * Mat3::Identity();
  Vec3 axis = squared.col(0);
  for (int i = 1; i < 3; ++i) {
    if (squared.col(i).squaredNorm() > axis.squaredNorm()) axis = squared.col(i);
  }
  if (axis.dot(twice_sine) < 0.0) axis = -axis;
  return angle_rad / axis.norm() * axis;
}

}  // namespace underact
