#include "core/chain/position_inverse.h"

#include <algorithm>
#include <cmath>

#include "core/base/axis_geometry.h"
#include "core/chain/trig_equation.h"

namespace underact::chain {
namespace {

/// The task, with the scale of its tolerances.
struct PositionTask {
  std::array<Joint, 3> joints;
  Vec3 p_home, p_wanted;
  double scale_m = 1.0;
};

bool turns(const Joint& joint) noexcept {
  return joint.type == JointType::Revolute;
}

void add(PositionAnswers& answers, double q1, double q2, double q3) noexcept {
  if (answers.count < answers.all.size()) answers.all[answers.count++] = {q1, q2, q3};
}

/// Each root in t of both halves of a turn (or of a slide).
template <class Polynomial, class Each>
void forEachRoot(JointType type, const Polynomial& polynomialIn, const Each& each) noexcept {
  for (const bool far : {false, true}) {
    const UnknownOfJoint unknown{type, far};
    const JointRoots roots = unknown.valuesOf(polynomialIn(unknown));
    for (std::size_t i = 0; i < roots.count; ++i) each(roots.all[i]);
    if (type == JointType::Prismatic) return;
  }
}

Quadratic combined(const Quadratic& a, double factor_a, const Quadratic& b, double factor_b) noexcept {
  return {factor_a * a[0] + factor_b * b[0], factor_a * a[1] + factor_b * b[1], factor_a * a[2] + factor_b * b[2]};
}

constexpr Quadratic kOne{1.0, 0.0, 0.0};

/// Joint 1 for a point that joint 2 has taken to w.
double firstAngle(const PositionTask& task, const Vec3& w) noexcept {
  const Joint& one = task.joints[0];
  return angleAbout(one.axis_W, w - one.p_WJ, task.p_wanted - one.p_WJ);
}

/// Joint 2 such that the distance from axis 1 and the height along it come out right, whichever of the two joint 2
/// decides about.
void addSecondTurns(const PositionTask& task, const Vec3& w, double q3, PositionAnswers& answers) noexcept {
  const Joint &one = task.joints[0], &two = task.joints[1];
  const MovedPoint moved = movedBy(two, w);
  const bool parallel = areParallel(one.axis_W, two.axis_W);
  const Vec3 offset = moved.fixed - one.p_WJ, wanted = task.p_wanted - one.p_WJ;
  AngleRoots two_rad;
  if (parallel) {
    const double scale = task.scale_m * task.scale_m;
    const Vec3 level = perpendicularPart(one.axis_W, offset);
    const double fixed =
        level.squaredNorm() + moved.cosine.squaredNorm() - perpendicularPart(one.axis_W, wanted).squaredNorm();
    two_rad = rootsOfAngle(fixed, 2.0 * level.dot(moved.cosine), 2.0 * level.dot(moved.sine), scale);
  } else {
    two_rad = rootsOfAngle(one.axis_W.dot(offset - wanted), one.axis_W.dot(moved.cosine), one.axis_W.dot(moved.sine),
                           task.scale_m);
  }
  if (two_rad.free) two_rad.roots = {{0.0}, 1};
  for (std::size_t i = 0; i < two_rad.roots.count; ++i) {
    const double q2 = two_rad.roots.all[i];
    add(answers, firstAngle(task, moved.at(q2)), q2, q3);
  }
}

/// Two turns, then any joint: the condition on the third joint is that of the height where axes 1 and 2 are parallel,
/// of the distance where they meet, else one of degree 4 of both.
void solveTurnTurn(const PositionTask& task, PositionAnswers& answers) noexcept {
  const Joint &one = task.joints[0], &two = task.joints[1], &three = task.joints[2];
  const MovedPoint w = movedBy(three, task.p_home);
  if (areParallel(one.axis_W, two.axis_W)) {
    const double height = one.axis_W.dot(task.p_wanted);
    forEachRoot(
        three.type,
        [&](const UnknownOfJoint& t) {
          return product(combined(t.along(one.axis_W, w), 1.0, t.denominator(), -height), kOne, 1.0);
        },
        [&](double q3) { addSecondTurns(task, w.at(q3), q3, answers); });
    return;
  }
  const Vec3 across = one.axis_W.cross(two.axis_W).normalized();
  const double offset = (two.p_WJ - one.p_WJ).dot(across);  // from axis 1 to axis 2 along their common normal
  const Vec3 foot_1 = nearestOn(one, two);
  const Vec3 foot_2 = foot_1 + offset * across;
  const double square = (task.p_wanted - foot_1).squaredNorm();
  if (std::abs(offset) <= kSame * task.scale_m) {
    forEachRoot(
        three.type,
        [&](const UnknownOfJoint& t) {
          return product(combined(t.squaredDistance(foot_1, w), 1.0, t.denominator(), -square), kOne, 1.0);
        },
        [&](double q3) { addSecondTurns(task, w.at(q3), q3, answers); });
    return;
  }
  // In the frame of axis 2: x across both axes, y = axis 2 x x. u and v are the parts of joint 2's point along them.
  const Vec3 y = two.axis_W.cross(across);
  const double k_y = one.axis_W.dot(y), k_z = one.axis_W.dot(two.axis_W);
  const double height = one.axis_W.dot(task.p_wanted - foot_1);
  MovedPoint from_foot = w;
  from_foot.fixed -= foot_2;
  const auto condition = [&](const UnknownOfJoint& t) {
    const Quadratic distance = t.squaredDistance(Vec3::Zero(), from_foot), level = t.along(two.axis_W, from_foot);
    const Quadratic a = combined(t.denominator(), square - offset * offset, distance, -1.0);
    const Quadratic b = combined(t.denominator(), height, level, -k_z);
    Quartic all = sum(product(a, a, k_y * k_y), product(b, b, 4.0 * offset * offset));
    all = sum(all, product(distance, t.denominator(), -4.0 * offset * offset * k_y * k_y));
    return sum(all, product(level, level, 4.0 * offset * offset * k_y * k_y));
  };
  forEachRoot(three.type, condition, [&](double q3) {
    const Vec3 at = w.at(q3) - foot_2;
    const double u = (square - at.squaredNorm() - offset * offset) / (2.0 * offset),
                 v = (height - k_z * two.axis_W.dot(at)) / k_y;
    const double x = at.dot(across), up = at.dot(y);
    const double q2 = atan2Of(v * x - u * up, u * x + v * up);
    add(answers, firstAngle(task, movedBy(two, w.at(q3)).at(q2)), q2, q3);
  });
}

/// Turn, slide, turn.
void solveTurnSlideTurn(const PositionTask& task, PositionAnswers& answers) noexcept {
  const Joint &one = task.joints[0], &two = task.joints[1], &three = task.joints[2];
  const MovedPoint w = movedBy(three, task.p_home);
  const double slope = one.axis_W.dot(two.axis_W), height = one.axis_W.dot(task.p_wanted);
  const double square = (task.p_wanted - one.p_WJ).squaredNorm();
  if (std::abs(slope) <= kSame) {
    forEachRoot(
        three.type,
        [&](const UnknownOfJoint& t) {
          return product(combined(t.along(one.axis_W, w), 1.0, t.denominator(), -height), kOne, 1.0);
        },
        [&](double q3) {
          const Vec3 at = w.at(q3) - one.p_WJ;
          const Roots slides = rootsOf({at.squaredNorm() - square, 2.0 * at.dot(two.axis_W), 1.0});
          for (std::size_t i = 0; i < slides.count; ++i) {
            add(answers, firstAngle(task, w.at(q3) + slides.all[i] * two.axis_W), slides.all[i], q3);
          }
        });
    return;
  }
  // The slide that brings the height: w + (height - axis 1 . w) / slope axis 2, whose distance is wanted.
  MovedPoint slid = w;
  for (Vec3* const part : {&slid.fixed, &slid.cosine, &slid.sine}) *part -= one.axis_W.dot(*part) / slope * two.axis_W;
  slid.fixed += height / slope * two.axis_W - one.p_WJ;
  const auto condition = [&](const UnknownOfJoint& t) {
    Quartic all = product(t.denominator(), t.denominator(), -square);
    for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())}) {
      const Quadratic part = t.along(axis, slid);
      all = sum(all, product(part, part, 1.0));
    }
    return all;
  };
  forEachRoot(three.type, condition, [&](double q3) {
    const double q2 = (height - one.axis_W.dot(w.at(q3))) / slope;
    add(answers, firstAngle(task, w.at(q3) + q2 * two.axis_W), q2, q3);
  });
}

/// One turn of `turning` between or before two slides; the turn is about its axis, the rest lies on a line.
void solveTwoSlides(const PositionTask& task, std::size_t turning, PositionAnswers& answers) noexcept {
  const Joint& turn = task.joints[turning];
  const std::size_t a = turning == 0 ? 1 : 0, b = 2;
  // before(s_a) = R(q) after(s_b): heights and distances from the turn's axis agree. Both from the turn's point.
  const Vec3 before = task.p_wanted - turn.p_WJ, after = task.p_home - turn.p_WJ;
  const Vec3 slide_a = task.joints[a].axis_W, slide_b = task.joints[b].axis_W;
  const double lift_a = turn.axis_W.dot(slide_a), lift_b = turn.axis_W.dot(slide_b);
  const double height = turn.axis_W.dot(before - after);
  const double square = lift_a * lift_a + lift_b * lift_b;
  if (!(square > kSame * kSame)) return;
  // (s_a, s_b) = nearest + t along, all that have the height.
  const double near_a = height * lift_a / square, near_b = height * lift_b / square;
  const double along_a = -lift_b / std::sqrt(square), along_b = lift_a / std::sqrt(square);
  const Vec3 left = turning == 0 ? before : Vec3(before - near_a * slide_a);
  const Vec3 left_by = turning == 0 ? Vec3(Vec3::Zero()) : Vec3(-along_a * slide_a);
  Vec3 right = after + near_b * slide_b, right_by = along_b * slide_b;
  if (turning == 0) right += near_a * slide_a, right_by += along_a * slide_a;
  const Roots roots =
      rootsOf({right.squaredNorm() - left.squaredNorm(), 2.0 * (right.dot(right_by) - left.dot(left_by)),
               right_by.squaredNorm() - left_by.squaredNorm()});
  for (std::size_t i = 0; i < roots.count; ++i) {
    const double t = roots.all[i];
    std::array<double, 3> q{};
    q[turning] = angleAbout(turn.axis_W, right + t * right_by, left + t * left_by);
    q[a] = near_a + t * along_a;
    q[b] = near_b + t * along_b;
    add(answers, q[0], q[1], q[2]);
  }
}

void solveThreeSlides(const PositionTask& task, PositionAnswers& answers) noexcept {
  Mat3 axes;
  for (Eigen::Index i = 0; i < 3; ++i) axes.col(i) = task.joints[static_cast<std::size_t>(i)].axis_W;
  if (!(std::abs(axes.determinant()) > kSame)) return;
  const Vec3 q = axes.inverse() * (task.p_wanted - task.p_home);
  add(answers, q.x(), q.y(), q.z());
}

/// The task read from the tip: e3^-1 e2^-1 e1^-1 wanted = home.
PositionTask reversedTask(const PositionTask& task) noexcept {
  return {{task.joints[2], task.joints[1], task.joints[0]}, task.p_wanted, task.p_home, task.scale_m};
}

bool isReversed(const std::array<Joint, 3>& joints) noexcept {  // the other way round is one of those that are solved
  return !turns(joints[0]) && turns(joints[2]);
}

void solveAsGiven(const PositionTask& task, PositionAnswers& answers) noexcept {
  const std::array<Joint, 3>& joints = task.joints;
  if (turns(joints[0]) && turns(joints[1])) return solveTurnTurn(task, answers);
  if (turns(joints[0]) && turns(joints[2])) return solveTurnSlideTurn(task, answers);
  if (turns(joints[0])) return solveTwoSlides(task, 0, answers);
  if (turns(joints[1])) return solveTwoSlides(task, 1, answers);
  solveThreeSlides(task, answers);
}

double scaleOf(const PositionTask& task) noexcept {
  return (task.joints[1].p_WJ - task.joints[0].p_WJ).norm() + (task.joints[2].p_WJ - task.joints[1].p_WJ).norm() +
         (task.p_home - task.joints[2].p_WJ).norm() + (task.p_wanted - task.joints[0].p_WJ).norm();
}

}  // namespace

bool placesPoint(std::span<const Joint, 3> joints, const Vec3& p_home) noexcept {
  // Where the three joints move the point independently at a configuration that nothing lines up by chance.
  constexpr std::array<std::array<double, 3>, 2> kSomewhere{{{0.3, 0.7, 1.1}, {-0.9, 0.4, -1.6}}};
  const double reach_m =
      (p_home - joints[0].p_WJ).norm() + (p_home - joints[1].p_WJ).norm() + (p_home - joints[2].p_WJ).norm();
  for (const std::array<double, 3>& q : kSomewhere) {
    Vec3 p = p_home;
    Mat3 J = Mat3::Zero();
    for (std::size_t i = 3; i-- > 0;) {
      const Joint& joint = joints[i];
      const SinCos turn = sinCos(q[i]);
      const Eigen::Index column = static_cast<Eigen::Index>(i);
      if (turns(joint)) {
        for (Eigen::Index later = column + 1; later < 3; ++later)
          J.col(later) = rotated(J.col(later), joint.axis_W, turn);
        p = joint.p_WJ + rotated(p - joint.p_WJ, joint.axis_W, turn);
        J.col(column) = joint.axis_W.cross(p - joint.p_WJ) / std::max(reach_m, 1e-300);
      } else {
        p += q[i] * joint.axis_W;
        J.col(column) = joint.axis_W;
      }
    }
    if (std::abs(J.determinant()) > 1e-6) return true;
  }
  return false;
}

PositionAnswers solvePosition(std::span<const Joint, 3> joints, const Vec3& p_home, const Vec3& p_wanted) noexcept {
  PositionTask task{{joints[0], joints[1], joints[2]}, p_home, p_wanted, 1.0};
  task.scale_m = scaleOf(task);
  PositionAnswers answers;
  if (!isReversed(task.joints)) {
    solveAsGiven(task, answers);
    return answers;
  }
  solveAsGiven(reversedTask(task), answers);
  for (std::size_t i = 0; i < answers.count; ++i) {
    const std::array<double, 3> q = answers.all[i];
    answers.all[i] = {-q[2], -q[1], -q[0]};
  }
  return answers;
}

}  // namespace underact::chain
