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
#include "tests/support/property.h"

namespace underact::chain::test {

namespace property = underact::test;

struct Arm {
  std::string name;
  std::vector<DhRow> rows;
  Pose X_WB = Pose::Identity();
  Pose X_NT = Pose::Identity();
  Chain chain() const { return chainFromDh(rows, X_WB, X_NT); }
};

/// One row, degrees and millimetres.
inline DhRow row(double alpha_deg, double a_mm, double d_mm, double theta_deg, double min_deg, double max_deg) {
  return {JointType::Revolute,        alpha_deg * kRadPerDegree, a_mm * kMetrePerMillimetre, theta_deg * kRadPerDegree,
          d_mm * kMetrePerMillimetre, min_deg * kRadPerDegree,   max_deg * kRadPerDegree};
}

/// The same numbers as resources/arms/puma-560.json, which says where they are from.
inline Arm puma() {
  return {"puma-560",
          {row(0, 0, 0, 0, -160, 160), row(-90, 0, 243.5, 0, -225, 45), row(0, 431.8, -93.4, 0, -45, 225),
           row(90, -20.3, 433.1, 0, -110, 170), row(-90, 0, 0, 0, -100, 100), row(90, 0, 0, 0, -266, 266)}};
}

/// The same numbers as resources/arms/abb-irb-120.json.
inline Arm irb120() {
  Arm arm{"abb-irb-120",
          {row(0, 0, 290, 0, -165, 165), row(-90, 0, 0, -90, -110, 110), row(0, 270, 0, 0, -110, 70),
           row(-90, 70, 302, 0, -160, 160), row(90, 0, 0, 0, -120, 120), row(-90, 0, 0, 180, -400, 400)}};
  arm.X_NT.translation() = Vec3(0, 0, 0.072);
  return arm;
}

/// Beckman 2007, table 3.1 and eq. 3.1; the tip is the wrist centre. Without limits.
inline Arm omni() {
  Arm arm{"omni-thesis",
          {row(0, 0, 0, 0, 0, 0), row(90, 0, 0, 0, 0, 0), row(0, 127.508, 0, 0, 0, 0), row(90, 0, 149.352, 0, 0, 0),
           row(-90, 0, 0, 0, 0, 0), row(90, 0, 0, 0, 0, 0)}};
  for (DhRow& one : arm.rows) one.min = -kInfinity, one.max = kInfinity;
  arm.X_WB.linear() << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  arm.X_WB.translation() = Vec3(0, 0.030, -0.176);
  return arm;
}

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
