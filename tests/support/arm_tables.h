#pragma once
#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/chain/chain.h"

namespace underact::chain::test {

/// A DH table with its base and its tool.
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
  arm.X_NT.translation() = Vec3(0, 0, 72 * kMetrePerMillimetre);
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

/// Kinova, Gen3 Ultra lightweight robot, User Guide: DH parameters and joint limits of the arm with seven joints, its
/// classic table written as a modified one. Joints 1, 3, 5 and 7 turn without end.
inline Arm gen3() {
  Arm arm{"gen3",
          {row(180, 0, -284.8, 0, 0, 0), row(90, 0, -11.8, 180, -128.9, 128.9), row(90, 0, -420.8, 180, 0, 0),
           row(90, 0, -12.8, 180, -147.8, 147.8), row(90, 0, -314.3, 180, 0, 0), row(90, 0, 0, 180, -120.3, 120.3),
           row(90, 0, -167.4, 180, 0, 0)}};
  for (std::size_t i = 0; i < 7; i += 2) arm.rows[i].min = -kInfinity, arm.rows[i].max = kInfinity;
  arm.X_NT.linear() << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  return arm;
}

}  // namespace underact::chain::test
