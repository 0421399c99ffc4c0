#pragma once
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "core/manipulator/descend.h"
#include "tests/core/chain/arms.h"
#include "tests/support/robots.h"

namespace underact::manipulator::test {

namespace property = underact::test;
using chain::Joint;
using chain::JointType;
using chain::test::about;
using chain::test::anyPose;
using chain::test::poseOf;

using underact::test::sliding;
using underact::test::turning;

/// A tip at p whose z points along x of W, as all round chains here have it at home.
inline Pose tipAt(const Vec3& p_WV) {
  Mat3 R;
  R << 0, 0, 1, 0, -1, 0, 1, 0, 0;
  return poseOf(R, p_WV);
}

inline chain::Chain chainOf(std::vector<Joint> joints, const Pose& X_WV_home) {
  return chain::makeChain(std::move(joints), X_WV_home, {}).value();
}
inline Manipulator made(Wanted wanted) {
  return makeManipulator(std::move(wanted), {}).value();
}

/// Radius 50 mm about z; on the circle, on the sphere, on the cylinder.
inline chain::Chain ring(double min_rad = -kInfinity, double max_rad = kInfinity) {
  return chainOf({turning(Vec3::UnitZ(), Vec3::Zero(), min_rad, max_rad)}, tipAt({0.050, 0, 0}));
}
inline chain::Chain ball() {
  return chainOf({turning(Vec3::UnitZ(), Vec3::Zero()), turning(-Vec3::UnitY(), Vec3::Zero())}, tipAt({0.050, 0, 0}));
}
inline chain::Chain tube() {
  return chainOf({turning(Vec3::UnitZ(), Vec3::Zero()), sliding(Vec3::UnitZ())}, tipAt({0.050, 0, 0}));
}

/// Joints about z one after the other, along x.
inline chain::Chain planarArm(const std::vector<double>& lengths_m, double limit_rad = kInfinity) {
  std::vector<Joint> joints;
  double x_m = 0.0;
  for (const double length_m : lengths_m) {
    joints.push_back(turning(Vec3::UnitZ(), {x_m, 0, 0}, -limit_rad, limit_rad));
    x_m += length_m;
  }
  return chainOf(std::move(joints), tipAt({x_m, 0, 0}));
}

/// Two joints about z, one along it, one more about it.
inline chain::Chain scara() {
  const Vec3 z_W = Vec3::UnitZ();
  return chainOf({turning(z_W, Vec3::Zero()), turning(z_W, {0.06, 0, 0}), sliding(z_W), turning(z_W, {0.11, 0, 0})},
                 tipAt({0.13, 0, 0}));
}

/// The first joints of an arm; its tip where theirs is when the others stay at 0.
inline chain::Chain firstOf(chain::Chain whole, std::size_t count) {
  whole.joints.resize(count);
  return whole;
}

/// Joints of any kind and any place within 0.1 m, one in three sliding, one in three with limits about home.
inline chain::Chain anyChain(property::Random& random, std::size_t count) {
  std::vector<Joint> joints;
  for (std::size_t i = 0; i < count; ++i) {
    const bool slides = random.below(3) == 0;
    Joint joint = slides ? sliding(random.direction()) : turning(random.direction(), random.inBox(0.1));
    if (random.below(3) == 0) {
      joint.min = random.between(-1.0, 0.0) * (slides ? 0.05 : 1.5);
      joint.max = joint.min + random.between(0.5, 2.0) * (slides ? 0.05 : 1.5);
    }
    joints.push_back(joint);
  }
  return chainOf(std::move(joints), anyPose(random, 0.1));
}

/// A value for each joint, within its limits.
inline Values anyPlace(property::Random& random, const Manipulator& m) {
  Values theta{};
  for (std::size_t i = 0; i < m.chain.joints.size(); ++i) {
    const double half = m.chain.joints[i].type == JointType::Revolute ? kPi : 0.1;
    theta[i] = random.between(-half, half);
  }
  return clampedToLimits(m, theta);
}

inline Energy energyAt(const Manipulator& m, const Pose& X_WT, const Values& theta) {
  Energy at;
  evaluate(m, X_WT, theta, at);
  return at;
}

inline constexpr Orientation kOrientations[] = {Orientation::None, Orientation::Axis, Orientation::Full};

}  // namespace underact::manipulator::test
