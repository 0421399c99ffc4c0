#include "core/chain/planar_inverse.h"

#include <algorithm>
#include <cmath>

#include "core/base/axis_geometry.h"
#include "core/chain/trig_equation.h"

namespace underact::chain {
namespace {

void put(PlanarAnswers& answers, double a, double b, double c = 0.0) noexcept {
  if (answers.count < answers.all.size()) answers.all[answers.count++] = {a, b, c};
}

bool spins(const Joint& joint) noexcept {
  return joint.type == JointType::Revolute;
}

Vec3 flat(const Vec3& normal, const Vec3& offset) noexcept {
  return perpendicularPart(normal, offset);
}

/// Where the motion takes a point.
Vec3 movedTo(const Vec3& normal, const PlanarMotion& motion, const Vec3& p) noexcept {
  return motion.p_moved + rotated(p - motion.p_home, normal, sinCos(motion.angle_rad));
}

/// Two joints that bring the point p to p_wanted: at most two answers.
PlanarAnswers twoForPoint(const Vec3& n, const Joint& one, const Joint& two, const Vec3& p,
                          const Vec3& p_wanted) noexcept {
  PlanarAnswers answers;
  const double scale =
      flat(n, one.p_WJ - two.p_WJ).norm() + flat(n, p - two.p_WJ).norm() + flat(n, p_wanted - one.p_WJ).norm();
  const Vec3 wanted = flat(n, p_wanted - one.p_WJ);
  if (spins(one) && spins(two)) {
    const MovedPoint moved = movedBy(two, p);
    const Vec3 offset = flat(n, moved.fixed - one.p_WJ);
    const AngleRoots found = rootsOfAngle(offset.squaredNorm() + moved.cosine.squaredNorm() - wanted.squaredNorm(),
                                          2.0 * offset.dot(moved.cosine), 2.0 * offset.dot(moved.sine), scale * scale);
    const Roots roots = found.free ? Roots{{0.0}, 1} : found.roots;
    for (std::size_t i = 0; i < roots.count; ++i) {
      put(answers, angleAbout(n, moved.at(roots.all[i]) - one.p_WJ, p_wanted - one.p_WJ), roots.all[i]);
    }
  } else if (spins(one)) {
    const Vec3 offset = flat(n, p - one.p_WJ);
    const Roots roots = rootsOf({offset.squaredNorm() - wanted.squaredNorm(), 2.0 * offset.dot(two.axis_W), 1.0});
    for (std::size_t i = 0; i < roots.count; ++i) {
      put(answers, angleAbout(n, offset + roots.all[i] * two.axis_W, wanted), roots.all[i]);
    }
  } else if (spins(two)) {
    const Vec3 offset = flat(n, p_wanted - two.p_WJ), arm = flat(n, p - two.p_WJ);
    const Roots roots = rootsOf({offset.squaredNorm() - arm.squaredNorm(), -2.0 * offset.dot(one.axis_W), 1.0});
    for (std::size_t i = 0; i < roots.count; ++i) {
      put(answers, roots.all[i], angleAbout(n, arm, offset - roots.all[i] * one.axis_W));
    }
  } else {
    const double area = n.dot(one.axis_W.cross(two.axis_W));
    const Vec3 offset = flat(n, p_wanted - p);
    if (std::abs(area) > kSame)
      put(answers, n.dot(offset.cross(two.axis_W)) / area, n.dot(one.axis_W.cross(offset)) / area);
  }
  return answers;
}

/// Three joints for the angle and the point. The last revolute joint takes the rest of the angle, the other two bring a
/// point on its axis (which it does not move) to its place; slides after it are seen from the far end.
PlanarAnswers threeForMotion(const Vec3& n, const std::vector<Joint>& level, const PlanarMotion& wanted) noexcept {
  PlanarAnswers answers;
  if (spins(level[2])) {
    const Vec3& pivot = level[2].p_WJ;
    answers = twoForPoint(n, level[0], level[1], pivot, movedTo(n, wanted, pivot));
    for (std::size_t i = 0; i < answers.count; ++i) {
      std::array<double, 3>& q = answers.all[i];
      q[2] = wanted.angle_rad - (spins(level[0]) ? q[0] : 0.0) - (spins(level[1]) ? q[1] : 0.0);
    }
    return answers;
  }
  if (!spins(level[0]) && !spins(level[1])) return answers;
  if (spins(level[0]) && spins(level[1])) {
    // e1 e2 = N T(-s d): on the pivot of joint 2, |N J2 - s N d - J1| is the length between the pivots.
    const Vec3 &one = level[0].p_WJ, &two = level[1].p_WJ;
    const Vec3 offset = flat(n, movedTo(n, wanted, two) - one);
    const Vec3 slide = rotated(level[2].axis_W, n, sinCos(wanted.angle_rad));
    const Roots roots =
        rootsOf({offset.squaredNorm() - flat(n, two - one).squaredNorm(), -2.0 * offset.dot(slide), 1.0});
    for (std::size_t i = 0; i < roots.count; ++i) {
      const double q1 = angleAbout(n, two - one, offset - roots.all[i] * slide);
      put(answers, q1, wanted.angle_rad - q1, roots.all[i]);
    }
    return answers;
  }
  // One turn, by the whole angle, and two slides: each moves the tip in a fixed direction.
  const std::size_t turning = spins(level[0]) ? 0 : 1, other = 1 - turning;
  const SinCos turn = sinCos(wanted.angle_rad);
  const Vec3 last = rotated(level[2].axis_W, n, turn);
  const Vec3 first = turning == 0 ? rotated(level[1].axis_W, n, turn) : level[0].axis_W;
  const Vec3& pivot = level[turning].p_WJ;
  const Vec3 offset = flat(n, movedTo(n, wanted, pivot) - pivot);
  const double area = n.dot(first.cross(last));
  if (!(std::abs(area) > kSame)) return answers;
  std::array<double, 3> q{};
  q[turning] = wanted.angle_rad;
  q[other] = n.dot(offset.cross(last)) / area;
  q[2] = n.dot(first.cross(offset)) / area;
  put(answers, q[0], q[1], q[2]);
  return answers;
}

}  // namespace

std::optional<PlanarArm> planarArm(const Chain& chain) {
  PlanarArm arm;
  const auto turning = std::find_if(chain.joints.begin(), chain.joints.end(), spins);
  if (turning == chain.joints.end()) return std::nullopt;
  arm.normal_W = turning->axis_W;
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    Joint joint = chain.joints[i];
    const bool upright = areParallel(joint.axis_W, arm.normal_W);
    const double sign = joint.axis_W.dot(arm.normal_W) < 0.0 && upright ? -1.0 : 1.0;
    if (spins(joint) && !upright) return std::nullopt;
    if (!spins(joint) && upright) {
      if (arm.quill) return std::nullopt;
      arm.quill = i;
      arm.quill_sign = sign;
      continue;
    }
    if (!spins(joint) && std::abs(joint.axis_W.dot(arm.normal_W)) > kSame) return std::nullopt;
    if (spins(joint)) joint.axis_W = arm.normal_W;
    arm.level.push_back(joint);
    arm.which.push_back(i);
    arm.sign.push_back(sign);
  }
  const std::size_t count = arm.level.size();
  const auto onOne = [&](const Joint& a, const Joint& b) {  // the same axis twice, or slides in the same direction
    if (spins(a) != spins(b)) return false;
    if (!spins(a)) return areParallel(a.axis_W, b.axis_W);
    return flat(arm.normal_W, a.p_WJ - b.p_WJ).norm() <= kSame * reachOf(chain);
  };
  for (std::size_t i = 1; i < count; ++i) {
    if (onOne(arm.level[i - 1], arm.level[i])) return std::nullopt;
  }
  if (count == 0 || count > 3) return std::nullopt;
  return arm;
}

PlanarAnswers solvePlanar(const Vec3& normal_W, const std::vector<Joint>& level, const PlanarMotion& wanted) noexcept {
  if (level.size() == 3) return threeForMotion(normal_W, level, wanted);
  if (level.size() == 2) return twoForPoint(normal_W, level[0], level[1], wanted.p_home, wanted.p_moved);
  PlanarAnswers answers;
  if (level.size() == 1)
    put(answers, angleAbout(normal_W, wanted.p_home - level[0].p_WJ, wanted.p_moved - level[0].p_WJ), 0.0);
  return answers;
}

}  // namespace underact::chain
