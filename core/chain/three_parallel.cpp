#include "core/chain/three_parallel.h"

#include <algorithm>
#include <cmath>

#include "core/base/axis_geometry.h"
#include "core/chain/trig_equation.h"
#include "core/chain/wrist.h"

namespace underact::chain {
namespace {

constexpr double kOutOfSight = 1e9;  // reaches
constexpr double kExact = 1e-14;     // rad, and of the reach

/// An angle of joint 1 or 5, its sine and cosine, and on which side of the middle it lies.
struct Side {
  double angle_rad = 0.0;
  SinCos turn;
  int side = 1;
  bool merged = false;  // there is no other side
};
struct Sides {
  std::array<Side, 4> all{};
  std::size_t count = 0;
};

/// The roots of fixed + cos q cosine + sin q sine = 0, with their sines in closed form: no trigonometry but the angle.
Sides sidesOf(double fixed, double cosine, double sine, double scale) noexcept {
  Sides sides;
  const double square = cosine * cosine + sine * sine, amplitude = std::sqrt(square);
  if (!(amplitude > kMergedShare * scale)) {  // no angle helps, or any does
    if (std::abs(fixed) <= kOutsideShare * scale) sides.all[0] = {0.0, {}, 1, true}, sides.count = 1;
    return sides;
  }
  const double inside = amplitude - std::abs(fixed);
  if (!(inside >= -kOutsideShare * scale)) return sides;
  const bool merged = inside <= kMergedShare * scale;
  const double across = merged ? 0.0 : std::sqrt(inside * (amplitude + std::abs(fixed)));
  const double along = merged ? std::copysign(amplitude, -fixed) : -fixed;
  const double unit = 1.0 / square;
  for (const int side : {1, -1}) {
    const double c = (along * cosine - side * across * sine) * unit, s = (along * sine + side * across * cosine) * unit;
    sides.all[sides.count++] = {0.0, {s, c}, side, merged};
    if (merged) break;
  }
  const auto [a, b] =
      atan2OfTwo(sides.all[0].turn.sin, sides.all[0].turn.cos, sides.all[1].turn.sin, sides.all[1].turn.cos);
  sides.all[0].angle_rad = a > -kPi ? a : kPi;
  sides.all[1].angle_rad = b > -kPi ? b : kPi;
  return sides;
}

/// The task as seen from home: the displacement of the last link.
struct Shift {
  Mat3 R;
  Vec3 p;
};

struct Wanted {
  const ThreeParallelArm& arm;
  Shift M;
  Vec3 axis_6_W;  // R axis 6
  Vec3 p_W56;     // M p_W56
};

/// axis 2 . e1^-1 v as fixed + cos cosine + sin sine in q1.
struct InJointOne {
  double fixed, cosine, sine;
};
InJointOne inJointOne(const ThreeParallelArm& arm, const Vec3& v) noexcept {
  const Vec3 &one = arm.joints[0].axis_W, &n = arm.joints[1].axis_W;
  const double level = one.dot(v) * one.dot(n);
  return {level, n.dot(v) - level, -n.dot(one.cross(v))};
}

/// Joint 1 where axes 5 and 6 meet: their point keeps its distance along axis 2.
Sides firstJoint(const Wanted& w) noexcept {
  const Joint& one = w.arm.joints[0];
  const Vec3& n = w.arm.joints[1].axis_W;
  const InJointOne height = inJointOne(w.arm, w.p_W56 - one.p_WJ);
  return sidesOf(height.fixed - n.dot(w.arm.p_W56 - one.p_WJ), height.cosine, height.sine, w.arm.reach_m);
}

/// Joint 1 where they do not: what joint 5 does to that point and to axis 6 gives its cosine and sine, whose squares
/// sum to 1.
Sides firstJointOfFour(const Wanted& w) noexcept {
  const Joint &one = w.arm.joints[0], &five = w.arm.joints[4];
  const Vec3& n = w.arm.joints[1].axis_W;
  const InJointOne height = inJointOne(w.arm, w.p_W56 - one.p_WJ), lean = inJointOne(w.arm, w.axis_6_W);
  const MovedPoint point = movedBy(five, w.arm.p_W56);
  Joint at_origin = five;
  at_origin.p_WJ.setZero();
  const MovedPoint axis = movedBy(at_origin, w.arm.joints[5].axis_W);
  const double a = n.dot(point.cosine), b = n.dot(point.sine), c = n.dot(axis.cosine), d = n.dot(axis.sine);
  const double det = a * d - b * c;
  Sides sides;
  if (!(std::abs(det) > kMergedShare * w.arm.reach_m)) return sides;
  const double fixed_1 = height.fixed - n.dot(point.fixed - one.p_WJ), fixed_2 = lean.fixed - n.dot(axis.fixed);
  for (const bool far : {false, true}) {
    const auto quadratic = [&](double k, double cosine, double sine) {
      const double sign = far ? -1.0 : 1.0;
      return Quadratic{k + sign * cosine, 2.0 * sign * sine, k - sign * cosine};
    };
    const Quadratic x = quadratic((d * fixed_1 - b * fixed_2) / det, (d * height.cosine - b * lean.cosine) / det,
                                  (d * height.sine - b * lean.sine) / det);
    const Quadratic y = quadratic((a * fixed_2 - c * fixed_1) / det, (a * lean.cosine - c * height.cosine) / det,
                                  (a * lean.sine - c * height.sine) / det);
    const Quadratic whole{1.0, 0.0, 1.0};
    const Roots roots =
        rootsWithin(sum(sum(product(x, x, 1.0), product(y, y, 1.0)), product(whole, whole, -1.0)), -1.0, 1.0);
    for (std::size_t i = 0; i < roots.count && sides.count < sides.all.size(); ++i) {
      const double q = wrappedOnce(2.0 * atan2Of(roots.all[i], 1.0) + (far ? kPi : 0.0));
      sides.all[sides.count] = {q, sinCos(q), sides.count % 2 == 0 ? 1 : -1, true};
      ++sides.count;
    }
  }
  return sides;
}

/// Joint 5: the angle of axis 6 to the three. lean: its cosine.
Sides fifthJoint(const ThreeParallelArm& arm, double lean) noexcept {
  const Vec3 &n = arm.joints[1].axis_W, &five = arm.joints[4].axis_W, &six = arm.joints[5].axis_W;
  const double level = five.dot(six) * n.dot(five);
  return sidesOf(level - lean, n.dot(six) - level, n.dot(five.cross(six)), 1.0);
}

/// What is left for joints 2 to 4, a motion in their plane: where it takes axis 4, seen from axis 2, and the direction
/// of the upper arm, both along u_W and v_W; and q6, whose angle is not needed before.
struct Planar {
  double x, y;
  double along, across;
  SinCos six;
};

/// Joints 2 to 4 and 6; for both elbows.
void addElbowed(const ThreeParallelArm& arm, const Planar& N, ThreeParallelSolution so_far,
                ThreeParallelSolutions& found) noexcept {
  const double x = N.x, y = N.y, square = x * x + y * y;
  const double far = arm.upper_m + arm.fore_m, near = std::abs(arm.upper_m - arm.fore_m);
  const double distance = std::sqrt(square), inside = std::min(far - distance, distance - near);
  if (!(inside >= -kOutsideShare * arm.reach_m)) return;
  const bool merged = inside <= kMergedShare * arm.reach_m;
  const double beyond = (far - distance) * (far + distance), within = (distance - near) * (distance + near);
  const double sine = merged ? 0.0 : std::sqrt(beyond * within);
  const double cosine = merged ? (beyond < within ? 1.0 : -1.0) : 0.5 * (within - beyond);
  const auto [all_rad, six_rad] = atan2OfTwo(N.across, N.along, N.six.sin, N.six.cos);
  so_far.q[5] = six_rad;
  const double bend_unit = 0.5 / (arm.upper_m * arm.fore_m);
  std::array<double, 2> bend_rad{}, lift_rad{};
  std::array<double, 2> s3{}, c3{}, s2{}, c2{};
  for (int i = 0; i < 2; ++i) {
    const double scale = merged ? 1.0 : bend_unit, s = (i == 0 ? sine : -sine) * scale, c = cosine * scale;
    s3[static_cast<std::size_t>(i)] = s * arm.ahead - c * arm.aside;  // the bend from home's
    c3[static_cast<std::size_t>(i)] = c * arm.ahead + s * arm.aside;
    const double fx = arm.upper_m + arm.fore_m * c, fy = arm.fore_m * s;
    s2[static_cast<std::size_t>(i)] = fx * y - fy * x;
    c2[static_cast<std::size_t>(i)] = fx * x + fy * y;
  }
  const auto [b0, b1] = atan2OfTwo(s3[0], c3[0], s3[1], c3[1]);
  bend_rad = {b0, b1};
  const bool folded = !(distance > kMergedShare * arm.reach_m);
  const auto [l0, l1] = atan2OfTwo(s2[0], c2[0], s2[1], c2[1]);
  lift_rad = {folded ? 0.0 : l0, folded ? 0.0 : l1};
  for (std::size_t i = 0; i < (merged ? 1U : 2U) && found.count < found.all.size(); ++i) {
    ThreeParallelSolution& one = found.all[found.count++];
    one = so_far;
    one.elbow = i == 0 ? 1 : -1;
    one.exact &= !merged;
    const double q4 = all_rad - lift_rad[i] - bend_rad[i];
    one.q[1] = arm.sign[1] * lift_rad[i];
    one.q[2] = arm.sign[2] * bend_rad[i];
    one.q[3] = arm.sign[3] * wrappedOnce(wrappedOnce(q4));
    for (double& angle_rad : one.q) angle_rad = angle_rad > -kPi ? angle_rad : kPi;
  }
}

}  // namespace

std::optional<ThreeParallelArm> threeParallelArm(const Chain& chain) noexcept {
  if (chain.joints.size() != 6) return std::nullopt;
  ThreeParallelArm arm;
  for (std::size_t i = 0; i < 6; ++i) {
    if (chain.joints[i].type != JointType::Revolute) return std::nullopt;
    arm.joints[i] = chain.joints[i];
    arm.sign[i] = 1.0;
  }
  const auto parallel = [&](std::size_t a, std::size_t b) {
    return areParallel(arm.joints[a].axis_W, arm.joints[b].axis_W);
  };
  if (!parallel(1, 2) || !parallel(1, 3) || parallel(0, 1) || parallel(3, 4) || parallel(4, 5)) return std::nullopt;
  const Vec3& n = arm.joints[1].axis_W;
  for (const std::size_t i : {2U, 3U}) {
    arm.sign[i] = arm.joints[i].axis_W.dot(n) < 0.0 ? -1.0 : 1.0;
    arm.joints[i].axis_W = n;
  }
  arm.reach_m = reachOf(chain);
  const Vec3 upper_W = perpendicularPart(n, arm.joints[2].p_WJ - arm.joints[1].p_WJ);
  const Vec3 fore_W = perpendicularPart(n, arm.joints[3].p_WJ - arm.joints[2].p_WJ);
  arm.upper_m = upper_W.norm();
  arm.fore_m = fore_W.norm();
  const double near_m = kSame * arm.reach_m;
  if (!(arm.upper_m > near_m && arm.fore_m > near_m)) return std::nullopt;
  arm.u_W = upper_W / arm.upper_m;
  arm.v_W = n.cross(arm.u_W);
  arm.ahead = arm.u_W.dot(fore_W) / arm.fore_m;
  arm.aside = arm.v_W.dot(fore_W) / arm.fore_m;
  const Joint& five = arm.joints[4];
  const auto turnedBy5 = [&](const Vec3& v) {
    const MovedPoint moved = movedBy({JointType::Revolute, five.axis_W, Vec3::Zero()}, v);
    return TurnedVector{moved.fixed, moved.cosine, moved.sine};
  };
  arm.axis_5 = turnedBy5(n);
  arm.upper_5 = turnedBy5(arm.u_W);
  arm.p_54_5 = turnedBy5(arm.joints[3].p_WJ - five.p_WJ);
  arm.p_W56 = nearestOn(arm.joints[5], arm.joints[4]);
  const double gap_m = (arm.p_W56 - nearestOn(arm.joints[4], arm.joints[5])).norm();
  arm.meets = gap_m <= near_m;
  const double lean = std::max(n.cross(chain.joints[2].axis_W).norm(), n.cross(chain.joints[3].axis_W).norm());
  arm.exact = gap_m <= kExact * arm.reach_m && lean <= kExact;
  const Mat3 R_TW = chain.X_WT_home.linear().transpose();
  arm.X_TW.linear() = R_TW;
  arm.X_TW.translation() = -(R_TW * chain.X_WT_home.translation());
  return arm;
}

ThreeParallelSolutions solveAll(const ThreeParallelArm& arm, const Pose& X_WT) noexcept {
  ThreeParallelSolutions found;
  const bool usable = X_WT.translation().norm() <= kOutOfSight * (1.0 + arm.reach_m) &&
                      X_WT.linear().squaredNorm() <= 4.0;  // no for NaN
  if (!usable) return found;
  const Shift M{X_WT.linear() * arm.X_TW.linear(), X_WT.linear() * arm.X_TW.translation() + X_WT.translation()};
  const Vec3 &n = arm.joints[1].axis_W, &axis_1 = arm.joints[0].axis_W, &five_W = arm.joints[4].axis_W,
             &six_W = arm.joints[5].axis_W;
  const Vec3 &p_5 = arm.joints[4].p_WJ, &p_6 = arm.joints[5].p_WJ, &p_1 = arm.joints[0].p_WJ;
  const Vec3 p_21_W = p_1 - arm.joints[1].p_WJ, p_56_W = p_5 - p_6;
  const Wanted wanted{arm, M, M.R * six_W, M.R * arm.p_W56 + M.p};
  const Sides ones = arm.meets ? firstJoint(wanted) : firstJointOfFour(wanted);
  for (std::size_t i = 0; i < ones.count; ++i) {
    const Side& one = ones.all[i];
    // The plane of joints 2 to 4 as joint 1 turns it, and as the last link sees it, at home's axes.
    const Vec3 n_1 = rotated(n, axis_1, one.turn), u_1 = rotated(arm.u_W, axis_1, one.turn), v_1 = n_1.cross(u_1);
    const Vec3 n_seen = M.R.transpose() * n_1, u_seen = M.R.transpose() * u_1, v_seen = M.R.transpose() * v_1;
    const Vec3 p_1M_W = M.p - p_1;
    const double x_M = u_1.dot(p_1M_W) + arm.u_W.dot(p_21_W), y_M = v_1.dot(p_1M_W) + arm.v_W.dot(p_21_W);
    Sides fives = fifthJoint(arm, n_1.dot(wanted.axis_6_W));
    if (!arm.meets && fives.count == 2) {  // one of the two belongs to this joint 1
      const double height = n_1.dot(wanted.p_W56 - p_1);
      const auto misses = [&](const Side& side) {
        return std::abs(n.dot(p_5 - p_1 + rotated(arm.p_W56 - p_5, five_W, side.turn)) - height);
      };
      if (misses(fives.all[1]) < misses(fives.all[0])) fives.all[0] = fives.all[1];
      fives.count = 1;
    }
    for (std::size_t j = 0; j < fives.count; ++j) {
      const Side& five = fives.all[j];
      ThreeParallelSolution so_far;
      so_far.shoulder = one.side;
      so_far.wrist = five.side;
      so_far.exact = arm.exact && !one.merged && !five.merged;
      so_far.q[0] = one.angle_rad;
      so_far.q[4] = five.angle_rad;
      const Vec3 n_of_five = arm.axis_5.back(five.turn);
      const bool straight = n_of_five.cross(six_W).squaredNorm() <= kOutsideShare * kOutsideShare;
      so_far.exact &= !straight;
      // The turn about axis 6 that takes n_seen to n_of_five; both stand at right angles to it in the same height.
      const Vec3 a = six_W.cross(n_seen), b = six_W.cross(n_of_five);
      SinCos six;
      if (!straight) {
        const double sine = six_W.dot(a.cross(b)), cosine = a.dot(b), length = std::sqrt(sine * sine + cosine * cosine);
        if (length > 0.0) six = {sine / length, cosine / length};
      }
      // N = e1^-1 M e6^-1 e5^-1, of one direction and of one point.
      const SinCos back_6 = reversed(six);
      const Vec3 u = rotated(arm.upper_5.back(five.turn), six_W, back_6);
      const Vec3 p = p_6 + rotated(p_56_W + arm.p_54_5.back(five.turn), six_W, back_6);
      const Planar N{u_seen.dot(p) + x_M, v_seen.dot(p) + y_M, u_seen.dot(u), v_seen.dot(u), six};
      addElbowed(arm, N, so_far, found);
    }
  }
  return found;
}

}  // namespace underact::chain
