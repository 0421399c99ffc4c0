#include "core/chain/closed_form.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/chain/rotation.h"

namespace underact::chain {
namespace {

constexpr double kTooFar = 1e9;  // reaches

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
  both.exact = inside_m >= -kOutsideShare * arm.reach_m;
  both.merged = inside_m <= kMergedShare * arm.reach_m;
  if (radius_m <= kMergedShare * arm.reach_m) return both;  // C on axis 1: the angle is free, or no angle helps
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
  both.exact = inside_m >= -kOutsideShare * arm.reach_m;
  both.merged = inside_m <= kMergedShare * arm.reach_m;
  both.middle_rad = arm.elbow_middle_rad;
  // The law of cosines in factors: near the boundary the plain difference would be all rounding.
  const double beyond = (far_m - distance_m) * (far_m + distance_m),
               within = (distance_m - near_m) * (distance_m + near_m);
  both.half_rad =
      both.merged ? (beyond < within ? 0.0 : kPi) : atan2Of(std::sqrt(beyond * within), 0.5 * (within - beyond));
  return both;
}

/// Joints 4 to 6, for each solution of joint 5. so_far: joints 1 to 3 and their branches.
void addWrists(const SphericalWristArm& arm, const WristTask& task, const Solution& so_far, Solutions& found) noexcept {
  const WristAnswers wrists = solveWrist(arm.wrist, task);
  for (int i = 0; i < wrists.count; ++i) {
    const WristAnswer& wrist = wrists.all[static_cast<std::size_t>(i)];
    Solution& one = found.all[found.count++];
    one = so_far;
    one.wrist = 1 - 2 * i;
    one.exact = one.exact && wrists.exact;
    std::copy(wrist.q.begin(), wrist.q.end(), one.q.begin() + 3);
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
    one.q[1] = distance_m > kMergedShare * arm.reach_m ? angleAbout(axis_2_W, bent_W, p_C_W) : 0.0;
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
  const WristTask task{R_W * arm.axis_W[5], R_W * arm.wrist.across_W};
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
