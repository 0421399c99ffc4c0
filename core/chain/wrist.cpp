#include "core/chain/wrist.h"

#include <algorithm>
#include <cmath>

#include "core/base/axis_geometry.h"
#include "core/chain/rotation.h"
#include "core/chain/trig_equation.h"

namespace underact::chain {
namespace {

/// Joint 5 gives axis 6 its angle to axis 4 (subproblem 4). axis_6_W: the wanted direction of axis 6, seen from the
/// forearm.
Branches bendOf(const WristAxes& wrist, const Vec3& axis_6_W) noexcept {
  const double cos_45 = wrist.axis_W[0].dot(wrist.axis_W[1]), cos_56 = wrist.axis_W[1].dot(wrist.axis_W[2]);
  const double cosine = wrist.axis_W[0].dot(axis_6_W), sine_squared = wrist.axis_W[0].cross(axis_6_W).squaredNorm();
  // The squared triple product of the three axes, 1 - a^2 - b^2 - c^2 + 2abc, without cancellation where axes 4 and 6
  // are nearly in line.
  const double turn = cosine > 0.0 ? 1.0 : -1.0;
  const double gap = cos_45 - turn * cos_56;
  const double triple_squared =
      sine_squared * (1.0 - 2.0 * turn * cos_45 * cos_56 / (1.0 + std::abs(cosine))) - gap * gap;
  Branches both;
  both.exact = triple_squared >= -kOutsideShare;
  both.merged = triple_squared <= kMergedShare * std::max(kMergedShare, std::abs(gap));
  both.middle_rad = wrist.middle_rad;
  both.half_rad = atan2Of(both.merged ? 0.0 : std::sqrt(triple_squared), cosine - cos_45 * cos_56);
  return both;
}

bool onAxis(const Vec3& p_W, const Joint& joint, double near_m) noexcept {
  return perpendicularPart(joint.axis_W, p_W - joint.p_WJ).norm() <= near_m;
}

}  // namespace

WristAxes wristAxes(const Vec3& first_W, const Vec3& second_W, const Vec3& third_W) noexcept {
  return {{first_W, second_W, third_W}, third_W.unitOrthogonal(), angleAbout(second_W, third_W, first_W)};
}

std::optional<Vec3> meetingPoint(std::span<const Joint, 3> joints, double near_m) noexcept {
  for (const Joint& joint : joints) {
    if (joint.type != JointType::Revolute) return std::nullopt;
  }
  if (areParallel(joints[0].axis_W, joints[1].axis_W) || areParallel(joints[1].axis_W, joints[2].axis_W))
    return std::nullopt;
  const Vec3 p_WC = nearestOn(joints[1], joints[0]);
  if (!onAxis(p_WC, joints[0], near_m) || !onAxis(p_WC, joints[2], near_m)) return std::nullopt;
  return p_WC;
}

WristAnswers solveWrist(const WristAxes& wrist, const WristTask& task) noexcept {
  const Branches five = bendOf(wrist, task.axis_6_W);
  const auto [bend_of_first, bend_of_second] = sinCosOfTwo(five.answer(1), five.answer(-1));
  WristAnswers answers;
  answers.count = five.count();
  answers.exact = five.exact;
  for (int i = 0; i < answers.count; ++i) {
    const SinCos& bend = i == 0 ? bend_of_first : bend_of_second;
    WristAnswer& one = answers.all[static_cast<std::size_t>(i)];
    one.q[1] = wrappedOnce(five.answer(1 - 2 * i));
    const Vec3 axis_6_W = rotated(wrist.axis_W[2], wrist.axis_W[1], bend);
    const bool straight = five.merged && wrist.axis_W[0].cross(axis_6_W).squaredNorm() <= kOutsideShare * kOutsideShare;
    const AxisRotation four = straight ? AxisRotation{} : rotationAbout(wrist.axis_W[0], axis_6_W, task.axis_6_W);
    one.q[0] = four.angle_rad;
    const Vec3 across_W =
        rotated(rotated(task.across_W, wrist.axis_W[0], reversed(four.turn)), wrist.axis_W[1], reversed(bend));
    one.q[2] = angleAbout(wrist.axis_W[2], wrist.across_W, across_W);
  }
  return answers;
}

}  // namespace underact::chain
