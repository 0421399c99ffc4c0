#pragma once
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/chain/chain.h"
#include "core/chain/kinematics.h"
#include "tests/support/arm_tables.h"
#include "tests/support/property.h"

namespace underact::chain::test {

namespace property = underact::test;

using Angles = std::array<double, 6>;

inline std::vector<Arm> arms() {
  return {puma(), irb120(), omni()};
}

inline Mat3 about(const Vec3& axis, double angle_rad) {
  return Eigen::AngleAxisd(angle_rad, axis).toRotationMatrix();
}

inline Pose poseOf(const Mat3& R, const Vec3& p) {
  Pose X = Pose::Identity();
  X.linear() = R;
  X.translation() = p;
  return X;
}

inline Pose anyPose(property::Random& random, double half_m) {
  const Vec3 axis = random.direction();
  const double angle_rad = random.between(-kPi, kPi);
  return poseOf(about(axis, angle_rad), random.inBox(half_m));
}

/// Values that reach everywhere: each joint anywhere in a turn, or 0.3 m either way.
inline std::vector<double> anyValues(property::Random& random, const Chain& chain) {
  std::vector<double> q;
  for (const Joint& joint : chain.joints) {
    const double half = joint.type == JointType::Revolute ? kPi : 0.3;
    q.push_back(random.between(-half, half));
  }
  return q;
}

/// A table of `count` joints, one in three of them prismatic.
inline Arm anyArm(property::Random& random, std::size_t count) {
  Arm arm;
  arm.name = "any";
  for (std::size_t i = 0; i < count; ++i) {
    DhRow one = row(random.between(-180, 180), random.between(-200, 200), random.between(-200, 200),
                    random.between(-180, 180), -kInfinity, kInfinity);
    if (random.below(3) == 0) one.type = JointType::Prismatic;
    arm.rows.push_back(one);
  }
  arm.X_WB = anyPose(random, 0.3);
  arm.X_NT = anyPose(random, 0.1);
  return arm;
}

/// The largest difference of a rotation's entries, and of a place's coordinates, m.
inline double turnBetween(const Pose& a, const Pose& b) {
  return (a.linear() - b.linear()).cwiseAbs().maxCoeff();
}
inline double wayBetween(const Pose& a, const Pose& b) {
  return (a.translation() - b.translation()).cwiseAbs().maxCoeff();
}

}  // namespace underact::chain::test
