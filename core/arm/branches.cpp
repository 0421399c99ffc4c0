#include "core/arm/branches.h"

#include <algorithm>
#include <cmath>

#include "core/arm/planar.h"
#include "core/arm/wrist.h"
#include "core/base/trig.h"
#include "core/base/units.h"

namespace underact::arm {
namespace {

// Below this distance from axis 1, m, no direction is left: joint 1 is set to 0, with an error no larger than this.
constexpr double kNoDirection = 1e-12;

double half(double angle_rad) noexcept UNDERACT_REAL_TIME {  // half a turn further, in (-pi, pi]
  return angle_rad > 0.0 ? angle_rad - kPi : angle_rad + kPi;
}

double wrappedOnce(double angle_rad) noexcept UNDERACT_REAL_TIME {  // of an angle within a turn and a half
  if (angle_rad > kPi) return angle_rad - 2.0 * kPi;
  return angle_rad <= -kPi ? angle_rad + 2.0 * kPi : angle_rad;
}

/// Joints 1 to 3 of one branch, with what the wrist needs of them.
struct Elbowed {
  double q1_rad, q2_rad, q3_rad;
  SinCos turret, shin;  // of q1, of q2 + q3
};

/// The wrist's two solutions for joints 1 to 3, one where it is singular.
void addWrists(const Elbowed& at, const Mat3& R_BT, Branch branch, bool q1_free,
               Solutions& solutions) noexcept UNDERACT_REAL_TIME {
  const Wrist wrist = wristOf(forearmRotation(at.turret, at.shin).transpose() * R_BT);
  const bool in_line = wrist.bend_sin < kSingularSine;
  Family family = Family::None;
  if (in_line) family = wrist.ahead ? Family::Q4PlusQ6 : Family::Q6MinusQ4;
  if (q1_free) family = Family::Q1Free;
  solutions.at_wrist |= in_line;
  const auto add = [&](std::int8_t side, double four_rad, double five_rad, double six_rad) {
    branch.wrist = side;
    Solution& one = solutions.all[solutions.count++];
    one = {{at.q1_rad, at.q2_rad, at.q3_rad, four_rad, five_rad, six_rad}, branch, family, false};
  };
  add(1, wrist.q4_rad, wrist.q5_rad, wrist.q6_rad);
  if (!in_line) add(-1, half(wrist.q4_rad), -wrist.q5_rad, half(wrist.q6_rad));
}

}  // namespace

const char* name(Family family) {
  switch (family) {
    case Family::None:
      return nullptr;
    case Family::Q1Free:
      return "q1 free";
    case Family::Q4PlusQ6:
      return "q4+q6";
    case Family::Q6MinusQ4:
      return "q6-q4";
  }
  return nullptr;
}

bool isWithin(const JointLimits& limits, const JointAngles& q_rad) noexcept {
  for (std::size_t joint = 0; joint < q_rad.size(); ++joint) {
    const double angle_rad = joint == 4 ? std::abs(q_rad[joint]) : q_rad[joint];
    if (!(angle_rad >= limits.min_rad[joint] && angle_rad <= limits.max_rad[joint])) return false;
  }
  return true;
}

Solutions solveAll(const Geometry& geometry, const JointLimits& limits, const Pose& X_WT) noexcept {
  Solutions solutions;
  if (!solvesInTick(geometry)) return solutions;
  const PlanarReach reach = planarReach(geometry, X_WT.translation());
  if (!reach.reachable) return solutions;
  solutions.reachable = true;
  solutions.at_shoulder = reach.off_axis_m < kSingularDistance_m;
  solutions.at_elbow = reach.elbow.cos < kSingularSine;
  const Mat3& R_WT = X_WT.linear();
  Mat3 R_BT;
  R_BT << R_WT.row(2), R_WT.row(0), R_WT.row(1);  // R_WB^T, a permutation (eq. 3.1)

  const SinCos turret =
      reach.off_axis_m > kNoDirection ? SinCos{reach.y_m / reach.off_axis_m, reach.x_m / reach.off_axis_m} : SinCos{};
  const double q1_rad = reach.off_axis_m > kNoDirection ? atan2Of(reach.y_m, reach.x_m) : 0.0;
  const double q3_rad = atan2Of(reach.elbow.sin, reach.elbow.cos);
  // Facing the wrist centre with the elbow up and down; facing away mirrors both (A turns to -A).
  const Thigh up = thighOf(geometry, reach, 1.0), down = thighOf(geometry, reach, -1.0);
  const auto [q2_up_rad, q2_down_rad] = atan2OfTwo(up.thigh.sin, up.thigh.cos, down.thigh.sin, down.thigh.cos);
  const SinCos away{-turret.sin, -turret.cos};
  const bool one_elbow = solutions.at_elbow, one_shoulder = solutions.at_shoulder;
  const auto add = [&](const Elbowed& at, std::int8_t shoulder, std::int8_t elbow) {
    addWrists(at, R_BT, {shoulder, elbow, 1}, one_shoulder, solutions);
  };
  add({q1_rad, q2_up_rad, q3_rad, turret, up.shin}, 1, 1);
  if (!one_elbow) add({q1_rad, q2_down_rad, wrappedOnce(kPi - q3_rad), turret, down.shin}, 1, -1);
  if (!one_shoulder) {
    // q2' = pi - q2 of the other elbow; then q2' + q3' = 2 pi - (q2 + q3): the same cosine, the opposite sine.
    const auto opposite = [](const SinCos& of) { return SinCos{-of.sin, of.cos}; };
    add({half(q1_rad), wrappedOnce(kPi - q2_down_rad), q3_rad, away, opposite(down.shin)}, -1, 1);
    if (!one_elbow) {
      add({half(q1_rad), wrappedOnce(kPi - q2_up_rad), wrappedOnce(kPi - q3_rad), away, opposite(up.shin)}, -1, -1);
    }
  }
  for (std::size_t index = 0; index < solutions.count; ++index) {
    solutions.all[index].within_limits = isWithin(limits, solutions.all[index].q_rad);
  }
  return solutions;
}

}  // namespace underact::arm
