#include <cmath>

#include "core/arm/jacobian.h"
#include "core/arm/statics.h"
#include "core/scene/compile.h"
#include "tests/support/tick_hand.h"

namespace underact::tick {
namespace {

using test::Hand;
using test::hold;

const control::P kWeakWall{Vec3::Constant(10.0)};

/// A plane through p_W that pulls with 10 N/m, under the limits of a hand on the thesis's arm.
TickProgram pulledTo(const Vec3& p_W, const Vec3& normal_W) {
  const arm::Preset& preset = *arm::findPreset(arm::kDefaultArm);
  return makeProgram(preset.geometry, {hold(shape::makePlane(p_W, normal_W, {}).value(), kWeakWall)}, Combine::Sum,
                     safety::limitsForHands(0.88, Vec3(0.155, 0.112, 0.131)), preset.limits);
}

}  // namespace

TEST(TickLimits, TheTipIsTheSameToTheBitWithAndWithoutTheMotorsInView) {
  Hand with(pulledTo(Vec3::Zero(), Vec3::UnitY())),
      without({hold(shape::makePlane({0, 0, 0}, {0, 1, 0}, {}).value(), kWeakWall)}, Combine::Sum);
  for (int tick = 0; tick < 1000; ++tick) {
    const arm::JointAngles q_rad = test::scriptedAngles(tick);
    ASSERT_EQ(with.feed(q_rad).p_WT, without.feed(q_rad).p_WT) << tick;
  }
}

TEST(TickLimits, TheVelocityIsTheTipsOwn) {
  Hand hand(pulledTo(Vec3::Zero(), Vec3::UnitY()));
  for (int tick = 0; tick < 100; ++tick) hand.at(Vec3(0.0, 0.0, 0.02) + tick * Vec3(2e-4, 0.0, -1e-4));
  // 0.2 m/s for 20 of the filter's time constants; the joints cost 1e-13 m, a tick 1e-3 s.
  EXPECT_LT((hand.report().v_WT - Vec3(0.2, 0.0, -0.1)).norm(), 1e-7);
}

TEST(TickLimits, HeatIsThatOfTheTorquesThatHoldTheForce) {
  Hand hand(pulledTo({0.0, 0.05, 0.0}, Vec3::UnitY()));
  hand.settle({0.0, 0.0, 0.03});
  const Vec3 f_T_W = hand.report().force.f_T_W();
  ASSERT_GT(f_T_W.norm(), 0.4);
  const Vec3 before = hand.report().heat;
  hand.at({0.0, 0.0, 0.03});
  const Vec3 torque = arm::torqueOf(test::thesisGeometry(), hand.input.sample.q_rad, f_T_W);
  const Vec3 bears(0.155, 0.112, 0.131);
  for (Eigen::Index motor = 0; motor < 3; ++motor) {
    const double load = torque[motor] / bears[motor];
    EXPECT_NEAR(hand.report().heat[motor] - before[motor], 1e-3 / 60.0 * (load * load - before[motor]), 1e-15);
  }
  EXPECT_GT(hand.report().heat.maxCoeff(), 0.0);
}

TEST(TickLimits, AtAStopAForceAgainstItIsGoneAndTheReportSaysSo) {
  const arm::Preset& preset = *arm::findPreset(arm::kDefaultArm);
  arm::JointAngles q_rad{};
  q_rad[0] = preset.limits.max_rad[0];  // turned all the way; the tip may not go on along its way
  q_rad[1] = 0.9, q_rad[2] = 0.2, q_rad[4] = 1.2;
  const arm::Tip tip = arm::tip(preset.geometry, q_rad);
  const Vec3 on_W = tip.J_p.col(0).normalized();
  for (const double sign : {1.0, -1.0}) {
    Hand hand(pulledTo(tip.p_WT + sign * 0.05 * on_W, on_W));
    for (int tick = 0; tick < 400; ++tick) hand.feed(q_rad);
    EXPECT_NEAR(hand.report().f_T_W.norm(), 0.5, 1e-9);
    EXPECT_NEAR(hand.report().force.f_T_W().norm(), sign > 0.0 ? 0.0 : 0.5, 1e-9);
    EXPECT_NEAR(hand.report().cuts.edge_N, sign > 0.0 ? 0.5 : 0.0, 1e-9);
    EXPECT_NEAR(hand.report().cut_N, hand.report().cuts.edge_N, 1e-12);
  }
}

TEST(TickLimits, AFaultFromOutsideIsTheTicksFault) {
  Hand hand(pulledTo({0.0, 0.05, 0.0}, Vec3::UnitY()));
  hand.settle({0.0, 0.0, 0.03});
  hand.input.fault = {FaultKind::StoodStill, 1.25, 0.1};
  hand.at({0.0, 0.0, 0.03});
  hand.input.fault = {};
  hand.at({0.0, 0.0, 0.03});
  EXPECT_EQ(hand.report().fault.kind, FaultKind::StoodStill);
  EXPECT_EQ(hand.report().fault.seen, 1.25);
  EXPECT_EQ(hand.report().force.f_T_W(), Vec3(Vec3::Zero()));
}

TEST(TickLimits, AChangeOfGainsFadesInFromAnyForceAndLeavesNothingBehind) {
  Hand weak({hold(shape::makePoint({0, 0, 0}, {}).value(), kWeakWall)}, Combine::Sum);
  Hand strong({hold(shape::makePoint({0, 0, 0}, {}).value(), control::P{Vec3::Constant(15.0)})}, Combine::Sum);
  const Vec3 p_WT(0.0, 0.0, 0.04);
  weak.settle(p_WT);
  carryOver(weak.state(), strong.state());
  strong.input = weak.input;
  EXPECT_NEAR(strong.at(p_WT).f_T_W.norm(), 0.4, 1e-12);
  EXPECT_NEAR(strong.report().held[0].f_T_W.norm(), 0.6, 1e-12) << "the constraint's own force is the new one";
  EXPECT_NEAR(strong.at(p_WT).f_T_W.norm(), 0.6 - 0.2 * 20.0 / 21.0, 1e-12);
  strong.settle(p_WT);
  EXPECT_EQ(strong.report().f_T_W, strong.report().held[0].f_T_W);
}

TEST(TickLimits, AShippedSceneHasThemAllOn) {
  scene::Description scene;
  scene.title = "Point";
  scene.constraints.push_back({"p", scene::Point{}, target::Side::Both, {}, {}});
  const safety::Limits limits = scene::compile(scene).value().limits;
  EXPECT_TRUE(std::isfinite(limits.max_slew_N_per_s) && std::isfinite(limits.max_speed_m_per_s));
  EXPECT_TRUE(std::isfinite(limits.max_jump_m_per_s) && limits.edge_rad > 0.0);
  // 0.88 N on each joint's lever in the middle of the workspace.
  for (std::size_t joint = 0; joint < limits.thermal.continuous_N_m.size(); ++joint) {
    const double bears_N_m = limits.thermal.continuous_N_m[joint];
    EXPECT_TRUE(joint < 3 ? bears_N_m > 0.05 && bears_N_m < 0.2 : bears_N_m == 0.0) << joint;
  }
}

}  // namespace underact::tick
