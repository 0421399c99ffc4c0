#include "tests/error_bounds/oracle/arm.h"

#include <array>

#include "core/arm/forward.h"
#include "core/arm/jacobian.h"
#include "core/arm/statics.h"
#include "core/base/norms.h"
#include "tests/error_bounds/rows/draws.h"
#include "tests/error_bounds/rows/rows.h"

namespace underact::error_bounds {
namespace arm_rows {

/// The scale of rotations: each angle is known to an ulp of itself, and joints 2 and 3 are added before the sine is
/// taken.
Real turnScale(const arm::JointAngles& q_rad) {
  double largest_rad = 1.0;
  for (const double angle_rad : q_rad) largest_rad = std::max(largest_rad, std::abs(angle_rad));
  return largest_rad;
}
Real placeScale(const arm::Geometry& geometry, const arm::JointAngles& q_rad) {
  return (Real(geometry.upper_m) + geometry.fore_m) * turnScale(q_rad) + largestOf(geometry.p_WB);
}

Outcome judgeTip(Input& input) {
  const arm::Geometry geometry = drawArm(input);
  const arm::JointAngles q_rad = drawJoints(input);
  const Vec3 got = asTheServo([&] { return arm::tipPosition(geometry, q_rad); });
  return {ulpsOf(got, oracle::armPose(geometry, oracle::realOf(q_rad)).p_WT, placeScale(geometry, q_rad)), false};
}

Outcome poseProblem(Input& input) {
  const arm::Geometry geometry = drawArm(input);
  const arm::JointAngles q_rad = drawJoints(input);
  const Pose got = asTheServo([&] { return arm::tipPose(geometry, q_rad); });
  const oracle::ArmPose right = oracle::armPose(geometry, oracle::realOf(q_rad));
  return {std::max(ulpsOf(Vec3(got.translation()), right.p_WT, placeScale(geometry, q_rad)),
                   oracle::ulpsOf(got.linear(), right.R_WT, turnScale(q_rad))),
          false};
}

Outcome judgeJacobian(Input& input) {
  const arm::Geometry geometry = drawArm(input);
  const arm::JointAngles q_rad = drawJoints(input);
  const Mat6 J = asTheServo([&] { return arm::kinematics(geometry, q_rad).J; });
  const std::array<Real3, 3> places = oracle::armJacobian(geometry, q_rad);
  const std::array<Real3, 6> turns = oracle::armTurning(geometry, q_rad);
  const Real lengths = (Real(geometry.upper_m) + geometry.fore_m) * turnScale(q_rad);
  double worst = 0.0;
  for (std::size_t joint = 0; joint < 6; ++joint) {
    const auto column = static_cast<Eigen::Index>(joint);
    const Real3 place = joint < 3 ? places[joint] : Real3{0, 0, 0};
    worst = std::max({worst, ulpsOf(Vec3(J.col(column).head<3>()), place, lengths),
                      ulpsOf(Vec3(J.col(column).tail<3>()), turns[joint], turnScale(q_rad))});
  }
  return {worst, false};
}

/// f = (J J^T + damping)^-1 J tau by Cramer's rule. damping follows from the smallest gain, the root of the least root
/// of the characteristic polynomial, by Newton from below.
struct RightForce {
  Real3 f;
  Real min_gain, damping, weakest;  // weakest: the smallest eigenvalue of what is inverted
  Real largest_gain;
};

RightForce rightForce(const std::array<Real3, 3>& J, const Real3& torque) {
  // Rows of J J^T.
  std::array<Real3, 3> A;
  const auto at = [](const Real3& v, int i) { return i == 0 ? v.x : i == 1 ? v.y : v.z; };
  std::array<std::array<Real, 3>, 3> a;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      Real sum = 0;
      for (const Real3& column : J) sum += at(column, i) * at(column, j);
      a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = sum;
    }
  }
  const Real trace = a[0][0] + a[1][1] + a[2][2];
  const Real minors = a[0][0] * a[1][1] - a[0][1] * a[1][0] + a[0][0] * a[2][2] - a[0][2] * a[2][0] +
                      a[1][1] * a[2][2] - a[1][2] * a[2][1];
  const Real volume = dot(J[0], cross(J[1], J[2])), det = volume * volume;
  Real min = 0;  // x^3 - trace x^2 + minors x - det, which rises from -det to its least root
  for (int step = 0; step < 200; ++step) {
    const Real value = ((min - trace) * min + minors) * min - det;
    const Real slope = (3 * min - 2 * trace) * min + minors;
    if (slope <= 0) break;
    const Real next = min - value / slope;
    if (!(next > min * (1 + ldexp(Real(1), -200)))) break;
    min = next;
  }
  RightForce right;
  right.min_gain = sqrt(min);
  right.largest_gain = sqrt(trace);
  const Real share = right.min_gain / Real(arm::kDampedBelow_m);
  const Real strength = Real(arm::kDamping_m) * arm::kDamping_m;
  right.damping = share < 1 ? Real(strength * (1 - share * share)) : Real(0);
  right.weakest = min + right.damping;
  for (std::size_t i = 0; i < 3; ++i) a[i][i] += right.damping;
  for (std::size_t i = 0; i < 3; ++i) A[i] = {a[0][i], a[1][i], a[2][i]};
  const Real3 pushed = torque.x * J[0] + torque.y * J[1] + torque.z * J[2];
  right.f = oracle::solved(A, pushed);
  return right;
}

Outcome judgeForce(Input& input) {
  arm::Geometry geometry;
  geometry.upper_m = input.number("upper_m", [](Dice& dice) { return dice.between(0.05, 0.5); });
  geometry.fore_m = input.number("fore_m", [](Dice& dice) { return dice.between(0.05, 0.5); });
  const arm::JointAngles q_rad = drawJoints(input);
  const Vec3 torque_N_m = input.vector("torque_N_m", [](Dice& dice) { return dice.inBox(dice.scale()); });
  const arm::ForceOfTorque got = asTheServo([&] { return arm::forceOf(geometry, q_rad, torque_N_m); });
  const RightForce right = rightForce(oracle::armJacobian(geometry, q_rad), real(torque_N_m));
  // J is known to an ulp of its largest gain, and so is the inverted matrix, over its own smallest one.
  const Real scale = norm(real(torque_N_m)) * turnScale(q_rad) * right.largest_gain * right.largest_gain *
                     right.largest_gain / (right.weakest * right.weakest);
  return {std::max(ulpsOf(got.f_T_W, right.f, scale),
                   // At a share of 1 the square root turns an ulp into 1e-8 of itself, but the force depends on its
                   // square.
                   ulpsOf(Real(Real(got.damping_m) * got.damping_m - right.damping),
                          Real(arm::kDamping_m) * arm::kDamping_m * turnScale(q_rad) *
                              (right.largest_gain / Real(arm::kDampedBelow_m) + 1))),
          false};
}

constexpr std::array<Row, 4> kRows{{
    {"arm_tip", Kind::Arm, "Position of the tip from the joints",
     "ulp of the reach times the largest angle (1 rad at least), and of the base's position", 8, 4, judgeTip},
    {"arm_pose", Kind::Arm, "Pose of the stylus from the joints",
     "the same; of the orientation, ulp of the largest angle", 8, 4, poseProblem},
    {"arm_jacobian", Kind::Arm, "Jacobian of all six joints", "the same, without the base", 8, 60, judgeJacobian},
    {"arm_force", Kind::Arm, "Force from joint torques, with the damping near singularities",
     "ulp of |torque| times gain^3 / (smallest gain^2 + damping^2)^2", 16, 25, judgeForce},
}};

}  // namespace arm_rows

constinit const std::span<const Row> kArmRows = arm_rows::kRows;

}  // namespace underact::error_bounds
