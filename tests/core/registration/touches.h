#pragma once
#include <vector>

#include "core/registration/fit.h"
#include "tests/support/random.h"

namespace underact::registration {

/// What an arm at X_DW sees of the marks, each touched beside it by at most error_m along each axis.
inline std::vector<Touch> touched(const std::vector<Vec3>& points_D, const Pose& X_DW, double error_m,
                                  test::Random& random) {
  std::vector<Touch> touches;
  for (const Vec3& mark_D : points_D)
    touches.push_back({mark_D, X_DW.inverse() * (mark_D + random.inBox(error_m)), 0.0});
  return touches;
}

inline std::vector<Touch> touched(const std::vector<Vec3>& points_D, const Pose& X_DW) {
  test::Random random({1});
  return touched(points_D, X_DW, 0.0, random);
}

/// Any turn, and a place within 0.3 m.
inline Pose anyPose(test::Random& random) {
  Pose X_DW = Pose::Identity();
  X_DW.linear() = Eigen::AngleAxisd(random.between(-3.1, 3.1), random.direction()).toRotationMatrix();
  X_DW.translation() = random.inBox(0.3);
  return X_DW;
}

/// An arm that stands on the desk, turned about "up" by turn_rad.
inline Pose standing(double turn_rad, const Vec3& p_DW = Vec3(0.06, 0.11, -0.04)) {
  Pose X_DW = Pose::Identity();
  X_DW.linear() = Eigen::AngleAxisd(turn_rad, Vec3::UnitY()).toRotationMatrix();
  X_DW.translation() = p_DW;
  return X_DW;
}

}  // namespace underact::registration
