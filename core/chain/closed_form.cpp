#include "core/chain/closed_form.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/chain/rotation.h"

namespace underact::chain {
namespace {

constexpr double kOutside = 1e-9;  // within this outside counts as on the boundary; of the reach, or rad
constexpr double kMerged = 1e-12;  // and within this inside; a hundred times the rounding
constexpr double kTooFar = 1e9;    // reaches

/// The two solutions of a step: middle + half (+1) and middle - half (-1), or one where they coincide.
struct Branches {
  double middle_rad = 0.0;
  double half_rad = 0.0;
  bool merged = false;
  bool exact = true;
  int count() const noexcept UNDERACT_REAL_TIME { return merged ? 1 : 2; }
  double answer(int branch) const noexcept UNDERACT_REAL_TIME { return middle_rad + branch * half_rad; }
};

double wrappedOnce(double angle_rad) noexcept UNDERACT_REAL_TIME {  // of a sum of two in (-pi, pi]
  if (angle_rad > kPi) angle_rad -= 2.0 * kPi;
  if (angle_rad <= -kPi) angle_rad += 2.0 * kPi;
  return angle_rad;
}

/// Joint 1 brings C to its distance along axis 2, which the other joints cannot change (IK-Geo, subproblem 4).
/// p_J1C_W: the wanted position of C.
Branches shoulder(const SphericalWristArm& arm, const Vec3& p_J1C_W) noexcept {
  const Vec3 &axis_1_W = arm.axis_W[0], &axis_2_W = arm.axis_W[1];
  const double level_m = axis_1_W.dot(p_J1C_W) * axis_1_W.dot(axis_2_W);
  const double cosine_m = axis_2_W.dot(p_J1C_W) - level_m, sine_m = axis_2_W.dot(p_J1C_W.cross(axis_1_W));
  const double radius_m = std::sqrt(cosine_m * cosine_m + sine_m * sine_m);
  const double wanted_m = arm.along_m - level_m;
  const double inside_m = radius_m - std::abs(wanted_m);
  Branches both;
  both.exact = inside_m >= -kOutside * arm.reach_m;
  both.merged = inside_m <= kMerged * arm.reach_m;
  if (radius_m <= kMerged * arm.reach_m) return both;  // C on axis 1: the angle is free, or no angle helps
  both.middle_rad = atan2Of(sine_m, cosine_m);
  const double across_m = both.merged ? 0.0 : std::sqrt(inside_m * (radius_m + std::abs(wanted_m)));
  both.half_rad = atan2Of(across_m, wanted_m);
  return both;
}

/// Joint 3 brings C to its distance from axis 2 (subproblem 3).
Branches elbow(const SphericalWristArm& arm, double distance_m) noexcept {
  const double far_m = arm.upper_m + arm.fore_m, near_m = std::abs(arm.upper_m - arm.fore_m);
  const double inside_m = std::min(far_m - distance_m, distance_m - near_m);
  Branches both;
  both.exact = inside_m >= -kOutside * arm.reach_m;
  both.merged = inside_m <= kMerged * arm.reach_m;
  both.middle_rad = arm.elbow_middle_rad;
  // The law of cosines in factors: near the boundary the plain difference would be all rounding.
  const double beyond = (far_m - distance_m) * (far_m + distance_m),
               within = (distance_m - near_m) * (distance_m + near_m);
  both.half_rad =
      both.merged ? (beyond < within ? 0.0 : kPi) : atan2Of(std::sqrt(beyond * within), 0.5 * (within - beyond));
  return both;
}

/// Joint 5 gives axis 6 its angle to axis 4 (subproblem 4). axis_6_W: the wanted direction of axis 6, seen from the
/// forearm.
Branches wrist(const SphericalWristArm& arm, const Vec3& axis_6_W) noexcept {
  const double cos_45 = arm.axis_W[3].dot(arm.axis_W[4]), cos_56 = arm.axis_W[4].dot(arm.axis_W[5]);
  const double cosine = arm.axis_W[3].dot(axis_6_W), sine_squared = arm.axis_W[3].cross(axis_6_W).squaredNorm();
  // The squared triple product of the three axes, 1 - a^2 - b^2 - c^2 + 2abc, without cancellation where axes 4 and 6
  // are nearly in line.
  const double turn = cosine > 0.0 ? 1.0 : -1.0;
  const double gap = cos_45 - turn * cos_56;
  const double triple_squared =
      sine_squared * (1.0 - 2.0 * turn * cos_45 * cos_56 / (1.0 + std::abs(cosine))) - gap * gap;
  Branches both;
  both.exact = triple_squared >= -kOutside;
  both.merged = triple_squared <= kMerged * std::max(kMerged, std::abs(gap));
  both.middle_rad = arm.wrist_middle_rad;
  both.half_rad = atan2Of(both.merged ? 0.0 : std::sqrt(triple_squared), cosine - cos_45 * cos_56);
  return both;
}

/// The task of the wrist after joints 1 to 3: the wanted axis 6, and the line at right angles to it, seen from the
/// forearm.
struct WristTask {
  Vec3 axis_6_W;
  Vec3 across_W;
};

/// Joints 4 to 6 (subproblem 1, twice), for each solution of joint 5. so_far: joints 1 to 3 and their branches.
void addWrists(const SphericalWristArm& arm, const WristTask& task, const Solution& so_far, Solutions& found) noexcept {
  const Branches five = wrist(arm, task.axis_6_W);
  const auto [bend_of_first, bend_of_second] = sinCosOfTwo(five.answer(1), five.answer(-1));
  for (int i = 0; i < five.count(); ++i) {
    const SinCos& bend = i == 0 ? bend_of_first : bend_of_second;
    Solution& one = found.all[found.count++];
    one = so_far;
    one.wrist = 1 - 2 * i;
    one.exact = one.exact && five.exact;
    one.q[4] = wrappedOnce(five.answer(one.wrist));
    const Vec3 axis_6_W = rotated(arm.axis_W[5], arm.axis_W[4], bend);
    const bool straight = five.merged && arm.axis_W[3].cross(axis_6_W).squaredNorm() <= kOutside * kOutside;
    const AxisRotation four = straight ? AxisRotation{} : rotationAbout(arm.axis_W[3], axis_6_W, task.axis_6_W);
    one.q[3] = four.angle_rad;
    const Vec3 across_W =
        rotated(rotated(task.across_W, arm.axis_W[3], reversed(four.turn)), arm.axis_W[4], reversed(bend));
    one.q[5] = angleAbout(arm.axis_W[5], arm.across_W, across_W);
  }
}

/// Joints 2 and 3 for each solution of the elbow, then the wrist. p_C_W: C from axis 2, seen from link 1.
void addElbows(const SphericalWristArm& arm, const Vec3& p_C_W, const WristTask& task, const Solution& so_far,
               Solutions& found) noexcept {
  const Vec3& axis_2_W = arm.axis_W[1];
  const double distance_m = (p_C_W - axis_2_W.dot(p_C_W) * axis_2_W).norm();
  const Branches three = elbow(arm, distance_m);
  const auto [bend_of_first, bend_of_second] = sinCosOfTwo(three.answer(1), three.answer(-1));
  for (int i = 0; i < three.count(); ++i) {
    Solution one = so_far;
    one.elbow = 1 - 2 * i;
    one.exact = one.exact && three.exact;
    one.q[2] = wrappedOnce(three.answer(one.elbow));
    const Vec3 bent_W = arm.upper_W + rotated(arm.fore_W, arm.axis_W[2], i == 0 ? bend_of_first : bend_of_second);
    one.q[1] = distance_m > kMerged * arm.reach_m ? angleAbout(axis_2_W, bent_W, p_C_W) : 0.0;
    const SinCos back = reversed(sinCos(one.q[1] + arm.sense * one.q[2]));
    addWrists(arm, {rotated(task.axis_6_W, axis_2_W, back), rotated(task.across_W, axis_2_W, back)}, one, found);
  }
}

/// Puts the exact ones first, keeping the order of each kind.
void sortExactFirst(Solutions& found) noexcept {
  for (std::size_t i = 0; i < found.count; ++i) {
    if (!found.all[i].exact) continue;
    for (std::size_t at = i; at > found.exact; --at) std::swap(found.all[at], found.all[at - 1]);
    ++found.exact;
  }
}

}  // namespace

Solutions solveAll(const SphericalWristArm& arm, const Pose& X_WT) noexcept {
  Solutions found;
  const Vec3 p_J1C_W = X_WT.linear() * arm.p_TC + X_WT.translation() - arm.p_WJ1;
  const bool usable = p_J1C_W.norm() <= kTooFar * arm.reach_m && X_WT.linear().squaredNorm() <= 4.0;  // no for NaN
  if (!usable) return found;
  const Mat3 R_W = X_WT.linear() * arm.R_TW;  // of the last link, since home
  const WristTask task{R_W * arm.axis_W[5], R_W * arm.across_W};
  const Vec3& axis_1_W = arm.axis_W[0];
  const Branches one = shoulder(arm, p_J1C_W);
  for (int i = 0; i < one.count(); ++i) {
    Solution so_far;
    so_far.shoulder = 1 - 2 * i;
    so_far.exact = one.exact;
    so_far.q[0] = wrappedOnce(one.answer(so_far.shoulder));
    const SinCos back = reversed(sinCos(so_far.q[0]));
    const WristTask from_link_1{rotated(task.axis_6_W, axis_1_W, back), rotated(task.across_W, axis_1_W, back)};
    addElbows(arm, rotated(p_J1C_W, axis_1_W, back) - arm.offset_W, from_link_1, so_far, found);
  }
  sortExactFirst(found);
  return found;
}

}  // namespace underact::chain
