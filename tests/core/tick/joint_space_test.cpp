#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/arm/forward.h"
#include "core/arm/jacobian.h"
#include "tests/support/tick_hand.h"

// Control in joint space: torques of joints 1 to 3 from their errors, and the force they put on the tip.
namespace underact::tick {
namespace {

using control::P;
using control::PD;
using test::Hand;

const Vec3 kK(15.0, 16.0, 11.0);  // N m/rad
const shape::Shape kJointPoint = shape::makePoint({0.01, 0.02, 0.03}, {}).value();
const shape::Shape kJointFloor = shape::makePlane({0, 0, 0}, {0, 1, 0}, {}).value();

Entry joint(const shape::Shape& shape, const control::Law& law, target::Side side = target::Side::Both) {
  return {target::makeConstraint(shape, side, Vec3::Ones()), law, Space::Joint};
}

TickProgram jointProgram(const Entry& entry, const arm::JointLimits& limits = arm::kNoJointLimits) {
  return makeProgram(test::thesisGeometry(), {entry}, Combine::Sum, test::kTestLimits, limits);
}

Vec3 firstThree(const arm::JointAngles& q_rad) {
  return {q_rad[0], q_rad[1], q_rad[2]};
}

}  // namespace

TEST(JointSpace, TheForceIsThatOfTheTorques) {  // oracle: J_p^-T by a general solver, and joints from the other inverse
  test::Random random(test::Seed{20070451});
  for (int i = 0; i < test::sweep(2'000, 100'000); ++i) {
    const Vec3 p_WT(random.between(-0.08, 0.08), random.between(-0.06, 0.06), random.between(-0.035, 0.035));
    Hand hand(jointProgram(joint(kJointPoint, P{kK})));
    const TickReport& report = hand.at(p_WT);
    const arm::JointAngles q_rad = arm::solvePosition(test::thesisGeometry(), p_WT).q_rad,
                           wanted_rad = arm::solvePosition(test::thesisGeometry(), {0.01, 0.02, 0.03}).q_rad;
    const Vec3 torque_N_m = kK.cwiseProduct(firstThree(wanted_rad) - firstThree(q_rad));
    const Mat3 J = arm::positionJacobian(test::thesisGeometry(), q_rad);
    const Vec3 force_N = J.transpose().fullPivLu().solve(torque_N_m);
    ASSERT_LE((report.f_T_W - force_N).norm(), 1e-11) << p_WT.transpose();  // up to 60 N, condition below 10
    ASSERT_EQ(report.damping_m, 0.0);
    ASSERT_EQ(report.branch_changes, 0);
    ASSERT_FALSE(report.out_of_reach);
    ASSERT_EQ(report.held[0].p_WP, Vec3(0.01, 0.02, 0.03));  // what is drawn and recorded is the same target
  }
}

TEST(JointSpace, ItIsNotTheCartesianSpringButOneThatLeansAsideAwayFromItsMiddle) {
  // Close to the target f = J^-T K J^-1 e: along the way that joints 2 and 3 share it is softer than across it.
  const Vec3 target(0.01, 0.02, 0.03);
  const arm::JointAngles there_rad = arm::solvePosition(test::thesisGeometry(), target).q_rad;
  const Mat3 J = arm::positionJacobian(test::thesisGeometry(), there_rad), inverse = J.inverse();
  const Mat3 stiffness = inverse.transpose() * kK.asDiagonal() * inverse;
  double min_deg = 90.0;
  for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, 1, 1)}) {
    const Vec3 e_W = -1e-6 * direction.normalized();
    Hand hand(jointProgram(joint(kJointPoint, P{kK})));
    const Vec3 f_T_W = hand.at(target - e_W).f_T_W;
    EXPECT_LE((f_T_W - stiffness * e_W).norm(), 1e-4 * f_T_W.norm()) << direction.transpose();  // 1 um of 0.1 m, curved
    const double cosine = f_T_W.normalized().dot(e_W.normalized());
    min_deg = std::min(min_deg, 90.0 - std::acos(std::clamp(cosine, -1.0, 1.0)) / kRadPerDegree);
  }
  EXPECT_LT(min_deg, 85.0);  // somewhere the force leans by more than 5 degrees
}

TEST(JointSpace, AWallNeverPullsAndAnUntouchedOneIsFree) {
  test::Random random(test::Seed{20070452});
  Hand hand(jointProgram(joint(kJointFloor, PD{kK, Vec3::Constant(0.3)}, target::Side::Outside)));
  for (int i = 0; i < 3000; ++i) {
    const Vec3 p_WT(random.between(-0.05, 0.05), random.between(-0.03, 0.03), random.between(-0.03, 0.03));
    const TickReport& report = hand.at(p_WT);
    if (p_WT.y() > 0.0) {
      ASSERT_EQ(report.f_T_W, Vec3::Zero());
    } else {
      ASSERT_GE(report.f_T_W.y(), 0.0);
    }
  }
}

TEST(JointSpace, HoldsEveryShapeWithEveryLawAndStaysFinite) {
  for (const shape::Shape& shape : test::middleShapes()) {
    for (const control::Law& law : test::everyLaw()) {
      Hand hand(jointProgram(joint(shape, law)));
      bool pushed = false;
      for (int tick = 0; tick < 2000; ++tick) {
        const TickReport& report = hand.feed(test::scriptedAngles(tick));
        ASSERT_TRUE(report.f_T_W.allFinite()) << shape.index() << " " << law.index();
        ASSERT_LE(report.force.f_T_W().norm(), 0.88 * (1 + 1e-15));
        ASSERT_EQ(report.fault.kind, FaultKind::None);
        pushed = pushed || report.force.f_T_W().norm() > 0.1;
      }
      EXPECT_TRUE(pushed) << shape.index() << " " << law.index();
    }
  }
}

TEST(JointSpace, OnSingularPosesTheForceIsDampedAndFinite) {
  Hand hand(jointProgram(joint(kJointPoint, P{kK})));
  for (const arm::JointAngles& q_rad :
       {arm::JointAngles{0, 0.5, kPi / 2, 0, 1, 0}, arm::JointAngles{0, 0.5, -kPi / 2, 0, 1, 0},
        arm::JointAngles{0.3, kPi / 2, kPi / 2, 0, 1, 0}}) {  // stretched, folded, on axis 1
    const TickReport& report = hand.feed(q_rad);
    EXPECT_TRUE(report.f_T_W.allFinite());
    EXPECT_GT(report.damping_m, 0.0);
    EXPECT_LT(report.f_T_W.norm(), 50.0 / (2 * report.damping_m));  // |torque| / (2 lambda), torques below 50 N m
  }
}

TEST(JointSpace, ATargetOutOfReachDrawsToTheNearestPlaceAndSaysSo) {
  const shape::Shape far = shape::makePoint({0.0, 0.0, 0.5}, {}).value();
  Hand hand(jointProgram(joint(far, P{kK})));
  EXPECT_TRUE(hand.at({0.0, 0.0, 0.05}).out_of_reach);
  EXPECT_GT(hand.report().f_T_W.z(), 0.0);
}

TEST(JointSpace, ATargetBeyondAJointsLimitIsAskedForAtTheLimit) {
  arm::JointLimits limits = arm::kNoJointLimits;
  limits.max_rad[0] = 0.02;  // the target below asks for 0.194
  const shape::Shape aside = shape::makePoint({0.04, 0.0, 0.03}, {}).value();
  const Vec3 p_WT = arm::tipPosition(test::thesisGeometry(), {0.02, 0.6, 0.3, 0, 0, 0});
  Hand free(jointProgram(joint(aside, P{kK}))), limited(jointProgram(joint(aside, P{kK}), limits));
  const Vec3 across_W(std::cos(0.02), 0.0, -std::sin(0.02));  // the way of joint 1
  EXPECT_GT(free.at(p_WT).f_T_W.dot(across_W), 1.0);
  EXPECT_NEAR(limited.at(p_WT).f_T_W.dot(across_W), 0.0, 1e-10);
}

TEST(JointSpace, OnlyAProgramThatWorksOnJointsPaysForThem) {
  const TickProgram cartesian =
      makeProgram(test::thesisGeometry(), {test::hold(kJointPoint, P{kK})}, Combine::Sum, test::kTestLimits);
  EXPECT_FALSE(cartesian.needs.joints);
  EXPECT_EQ(bytesOf(makeState(cartesian)), sizeof(TickState));
  const TickProgram joints = jointProgram(joint(kJointPoint, P{kK}));
  EXPECT_TRUE(joints.needs.joints);
  EXPECT_GT(bytesOf(makeState(joints)), bytesOf(makeState(cartesian)));
}

TEST(JointSpace, AGainChangeKeepsTheBranch) {
  Hand hand(jointProgram(joint(kJointPoint, P{kK})));
  hand.at({0.0, 0.0, 0.0});
  TickState next = makeState(hand.program());
  carryOver(hand.state(), next);
  EXPECT_TRUE(next.entries[0].follower.begun);
  EXPECT_EQ(next.entries[0].follower.q_rad, hand.state().entries[0].follower.q_rad);
  TickState fresh = makeState(hand.program());
  carryOver(hand.state(), fresh, Carry::Arm);
  EXPECT_FALSE(fresh.entries[0].follower.begun);
}

}  // namespace underact::tick
