#include <gtest/gtest.h>

#include <cmath>

#include "core/arm/forward.h"
#include "core/tick/rest.h"
#include "tests/support/tick_hand.h"

// The stylus's turn in the tick: only where a constraint asks for it.
namespace underact::tick {
namespace {

using control::P;
using test::Hand;

const shape::Shape kRing = shape::makeCircle(Vec3::Zero(), Vec3::UnitZ(), 0.05, {}).value();

Entry influenced(const target::Influence& influence) {
  Entry entry = test::hold(kRing, P{Vec3::Constant(500.0)});
  entry.constraint.goal = target::InfluencedShape{kRing, influence};
  return entry;
}

const target::InfluenceState& influenceIn(const TickState& state) {
  return std::get<target::InfluenceState>(state.entries[0].target.memory);
}

TickProgram programOfAll(const std::vector<Entry>& entries) {
  return makeProgram(test::thesisGeometry(), entries, Combine::Sum, test::kTestLimits);
}

}  // namespace

TEST(InfluencedTick, FollowsTheStylusOfTheArm) {
  Hand hand({influenced({0.3, 1.0, 0.0})}, Combine::Sum);
  for (int tick = 0; tick < 500; ++tick) {
    const arm::JointAngles q_rad = test::scriptedAngles(11 * tick);
    const TickReport& report = hand.feed(q_rad, 0.09);  // time for any way round the rim
    const Pose X_WT = arm::tipPose(test::thesisGeometry(), q_rad);
    ASSERT_EQ(report.stylus_W, Vec3(X_WT.linear().col(2)));
    target::InfluenceState rest;
    const target::Influenced wanted =
        target::influencedTarget(kRing, {0.3, 1.0, 0.0}, X_WT.translation(), report.stylus_W, 0.0, rest);
    if (std::abs(wanted.angles.beta_rad - wanted.angles.alpha_rad) > 2.5) continue;  // near a tie the past decides
    ASSERT_LE((report.held[0].p_WP - wanted.p_WP).norm(), 1e-15) << tick;
    ASSERT_EQ(report.held[0].angles.theta_rad, wanted.angles.theta_rad);
    ASSERT_LE((report.f_T_W - 500.0 * (wanted.p_WP - X_WT.translation())).norm(), 1e-12);
  }
}

TEST(InfluencedTick, OnlyAProgramThatNeedsItPaysForTheWrist) {
  const TickProgram plain = programOfAll({test::hold(kRing, P{Vec3::Constant(500.0)})});
  EXPECT_FALSE(plain.needs.orientation);
  EXPECT_EQ(bytesOf(makeState(plain)), sizeof(TickState));
  const TickProgram turned = programOfAll({influenced({})});
  EXPECT_TRUE(turned.needs.orientation);
  EXPECT_GT(bytesOf(makeState(turned)), bytesOf(makeState(plain)));
  Hand hand(plain);
  EXPECT_EQ(hand.feed(test::scriptedAngles(3)).stylus_W, Vec3::Zero());
}

TEST(InfluencedTick, AtRestTheTurnIsThatOfTheLine) {
  const Mat3 R_WT = Eigen::AngleAxisd(0.5 * 3.14159265358979, Vec3::UnitY()).toRotationMatrix();  // z along x
  const TickReport report = evaluateAtRest(programOfAll({influenced({0.0})}), {0.0, 0.06, 0.0}, R_WT);
  EXPECT_LE((report.held[0].p_WP - Vec3(0.05, 0.0, 0.0)).norm(), 1e-15);
}

TEST(InfluencedTick, AGainChangeKeepsTheSideAndANewSceneDoesNot) {
  Hand hand({influenced({0.5})}, Combine::Sum);
  hand.feed(test::scriptedAngles(100));
  ASSERT_TRUE(influenceIn(hand.state()).begun);
  TickState next = makeState(hand.program()), fresh = makeState(hand.program());
  carryOver(hand.state(), next);
  carryOver(hand.state(), fresh, Carry::Arm);
  EXPECT_EQ(influenceIn(next).delta_rad, influenceIn(hand.state()).delta_rad);
  EXPECT_FALSE(influenceIn(fresh).begun);
}

}  // namespace underact::tick
