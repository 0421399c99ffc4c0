#pragma once
#include <utility>
#include <vector>

#include "core/target/constraint.h"
#include "tests/support/tick_hand.h"

namespace underact::test {

inline chain::Joint turning(const Vec3& axis_W, const Vec3& p_WJ, double min = -kInfinity, double max = kInfinity) {
  return {chain::JointType::Revolute, axis_W, p_WJ, min, max};
}
inline chain::Joint sliding(const Vec3& axis_W, double min = -kInfinity, double max = kInfinity) {
  return {chain::JointType::Prismatic, axis_W, Vec3::Zero(), min, max};
}

/// A chain with its tip at p_WV at home, z of V along z_W.
inline chain::Chain chainTo(std::vector<chain::Joint> joints, const Vec3& p_WV, const Vec3& z_W = Vec3::UnitZ()) {
  Pose X_WV = Pose::Identity();
  X_WV.linear() = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), z_W).toRotationMatrix();
  X_WV.translation() = p_WV;
  return chain::makeChain(std::move(joints), X_WV, {}).value();
}

/// A robot of each sort about the middle of the workspace: closed forms and iterations, every orientation, limits, a
/// spring, unequal gains, the thesis's law.
inline std::vector<manipulator::Manipulator> everyRobot() {
  using manipulator::ForceLaw;
  using manipulator::Method;
  using manipulator::Orientation;
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ(), none = Vec3::Zero();
  std::vector<manipulator::Manipulator> robots;
  const auto add = [&](manipulator::Wanted wanted) {
    robots.push_back(makeManipulator(std::move(wanted), {}).value());
  };
  const chain::Chain rim = chainTo({turning(z, none)}, 0.05 * x, x);
  const chain::Chain ball = chainTo({turning(y, none), turning(x, none)}, 0.04 * z);
  add({rim, Orientation::Axis, Vec3::Constant(500.0), 0.25});
  add({chainTo({turning(z, none), sliding(z, -0.02, 0.02)}, 0.03 * x, x), Orientation::Axis, Vec3::Constant(500.0),
       0.1});
  add({ball, Orientation::Axis, Vec3::Constant(500.0), 0.25});
  add({chainTo({sliding(x), sliding(y, -0.03, 0.03)}, none)});
  manipulator::Wanted angle{rim, Orientation::Angle, Vec3::Constant(500.0), 0.25};
  add(angle);
  angle.law = ForceLaw::Thesis52;
  add(angle);
  manipulator::Wanted turned{ball, Orientation::Full, {800.0, 200.0, 400.0}, 0.25};
  turned.method = Method::Iterative;
  add(turned);
  manipulator::Wanted bent{chainTo({turning(x, {-0.035, 0.0, -0.03}, -0.9, 0.9)}, {-0.035, 0.0, 0.03})};
  bent.spring[0] = 0.1;
  add(bent);
  add({chainTo({turning(y, {-0.07, 0, 0}, -1.2, 1.2), turning(y, {-0.02, 0, -0.03}, -1.2, 2.0),
                sliding(y, -0.025, 0.025), turning(y, {0.02, 0, 0})},
               {0.02, 0.0, 0.0}),
       Orientation::Full, Vec3::Constant(500.0), 0.1});
  add({chainTo({turning(y, {-0.1, 0, 0}), turning(z, {-0.1, 0, 0}), turning(z, {-0.07, 0.03, 0}),
                turning({0.94, -0.34, 0}, {-0.03, 0.016, 0}), turning(z, {-0.03, 0.016, 0}),
                turning({0.77, 0.64, 0}, {-0.03, 0.016, 0})},
               {-0.02, 0.02, 0.0}),
       Orientation::Full, Vec3::Constant(500.0), 0.1});
  return robots;
}

/// The stylus held to a robot's tip.
inline tick::Entry holdTo(const manipulator::Manipulator& robot, const control::Law& law) {
  tick::Entry entry;
  entry.constraint.goal = robot;
  entry.law = law;
  return entry;
}

}  // namespace underact::test
