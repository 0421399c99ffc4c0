#include "core/base/rotation.h"

#include "core/base/trig.h"

namespace underact {

Vec3 rotationVector(const Mat3& R) noexcept {
  const Vec3 twice_sine(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
  const double twice_sin = twice_sine.norm(), twice_cos = R(0, 0) + R(1, 1) + R(2, 2) - 1.0;
  const double angle_rad = atan2Of(twice_sin, twice_cos);
  if (twice_cos > 0.0 || twice_sin > 1e-6) return (twice_sin > 0.0 ? angle_rad / twice_sin : 0.5) * twice_sine;
  // Near half a turn the difference is lost: R + 1 is 2 axis axis^T, and its longest column the best seen. What is left
  // of the sine is not symmetric, and would turn the axis by a quarter of a microradian.
  const Mat3 doubled = 0.5 * (R + R.transpose()) + Mat3::Identity();
  Vec3 axis = doubled.col(0);
  for (int i = 1; i < 3; ++i) {
    if (doubled.col(i).squaredNorm() > axis.squaredNorm()) axis = doubled.col(i);
  }
  if (axis.dot(twice_sine) < 0.0) axis = -axis;
  return angle_rad / axis.norm() * axis;
}

}  // namespace underact
