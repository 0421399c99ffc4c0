#pragma once
#include <string>

#include "core/manipulator/follow.h"
#include "tests/core/manipulator/chains.h"

namespace underact::manipulator::test {

/// A manipulator, and a stylus about which a hand may move by 10 mm and 0.3 rad without leaving a valley: its home, or
/// somewhere that it bends well.
struct Held {
  std::string name;
  Manipulator manipulator;
  Pose X_WT;
};

inline Held held(std::string name, chain::Chain chain, Orientation orientation, const Pose& X_WT, double spring = 0.0) {
  Wanted wanted;
  wanted.chain = std::move(chain);
  wanted.orientation = orientation;
  wanted.ko_N_m_per_rad = 0.25;
  wanted.method = Method::Iterative;
  for (std::size_t i = 0; i < wanted.chain.joints.size(); ++i) wanted.spring[i] = spring;
  return {std::move(name), made(wanted), X_WT};
}

/// One of each kind of energy; 1 to 6 joints.
inline std::vector<Held> heldOnes() {
  const Mat3 out = tipAt(Vec3::Zero()).linear(), leaned = about(Vec3(0.3, 0.5, -0.4).normalized(), 0.4) * out;
  const chain::test::Arm omni = chain::test::omni(), puma = chain::test::puma();
  const Pose bent = chain::forward(puma.chain(), std::vector<double>{0.4, -0.7, 0.3, 0.5, 0.9, 0.2});
  const auto of = [](const Mat3& R, const Vec3& p) { return poseOf(R, p); };
  return {held("circle, angle", ring(), Orientation::Angle, of(leaned, {0.06, 0.01, 0.01})),
          held("circle, turn", ring(), Orientation::Full, of(leaned, {0.06, 0.01, 0.01})),
          held("sphere, place", ball(), Orientation::None, of(leaned, {0.05, 0.02, 0.03})),
          held("sphere, axis", ball(), Orientation::Axis, of(leaned, {0.05, 0.02, 0.03})),
          held("cylinder, axis", tube(), Orientation::Axis, of(leaned, {0.06, 0.01, 0.04})),
          held("plane of three joints, axis", planarArm({0.06, 0.05, 0.04}), Orientation::Axis,
               of(leaned, {0.09, 0.05, 0.02})),
          held("springs, place", planarArm({0.06, 0.05, 0.04}), Orientation::None, of(leaned, {0.12, 0.03, 0.02}), 0.3),
          held("scara, turn", scara(), Orientation::Full, of(leaned, {0.12, 0.09, 0.02})),
          held("five joints, turn", firstOf(puma.chain(), 5), Orientation::Full, bent),
          held("stretched arm, turn", omni.chain(), Orientation::Full,
               of(leaned, omni.X_WB.translation() + Vec3(0.1, 0.2, 0.24)))};
}

/// A closed path about p: harmonics small enough that 512 points of the trapezoid rule are exact to rounding.
struct Loop {
  Vec3 p_W = Vec3::Zero();
  Vec3 a_W = Vec3::Zero(), b_W = Vec3::Zero(), c_W = Vec3::Zero();
  Vec3 place(double s) const { return p_W + std::cos(s) * a_W + std::sin(s) * b_W + std::sin(2.0 * s) * c_W; }
  Vec3 slope(double s) const { return -std::sin(s) * a_W + std::cos(s) * b_W + 2.0 * std::cos(2.0 * s) * c_W; }
};

}  // namespace underact::manipulator::test
