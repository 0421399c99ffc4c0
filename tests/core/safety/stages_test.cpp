#include "core/safety/stages.h"

#include <cmath>

#include "tests/core/safety/pushed.h"
#include "tests/support/property.h"

namespace underact::safety {
namespace {

const Limits kHands = limitsForHands(0.88, Vec3(0.15, 0.15, 0.10));

/// Joints that move the tip along x, y, z by a lever of 0.15 m each.
Motion levers() {
  return threeJoints(0.15 * Mat3::Identity());
}

/// What the stops leave of a force.
Vec3 limitEdge(const Motion& motion, const Vec3& f_T_W) {
  return edgeShare(kHands, motion, {f_T_W, kZero}) * f_T_W;
}

}  // namespace

TEST(Speed, OnlyThePartThatDrivesTheStylusAlongFades) {
  const Vec3 f(0.3, 0.4, 0.0);
  EXPECT_EQ(limitSpeed(kHands, {1.0, 0.0, 0.0}, f), f) << "calm up to 1 m/s";
  EXPECT_LT((limitSpeed(kHands, {1.5, 0.0, 0.0}, f) - Vec3(0.15, 0.4, 0.0)).norm(), 1e-16) << "half way";
  EXPECT_LT((limitSpeed(kHands, {2.0, 0.0, 0.0}, f) - Vec3(0.0, 0.4, 0.0)).norm(), 1e-16);
  EXPECT_LT((limitSpeed(kHands, {9.0, 0.0, 0.0}, f) - Vec3(0.0, 0.4, 0.0)).norm(), 1e-16);
  EXPECT_EQ(limitSpeed(kHands, {-9.0, 0.0, 0.0}, f), f) << "a wall may stop what is fast";
}

TEST(Speed, AnArmThatItsOwnForceThrowsIsLetGo) {  // through the gate: mass without a hand, constant force asked
  GateState state = open();
  double v = 0.0;
  for (int tick = 0; tick < 2000; ++tick) {
    GateInput asked = push({0.88, 0.0, 0.0});
    asked.motion.v_WT = {v, 0.0, 0.0};
    const Gated gated = gate(kHands, state, asked, 1e-3);
    state = gated.next;
    v += 1e-3 * gated.force.f_T_W().x() / 0.045;
  }
  EXPECT_LT(v, 2.05);  // 39 m/s without; the filter's 5 ms at 19.6 m/s^2 are 0.1 m/s at the most
  EXPECT_GT(v, 1.5);
}

TEST(Jump, AFaultThatSaysHowFast) {
  GateInput asked = push({0.1, 0.0, 0.0});
  asked.motion.v_WT = {0.0, 25.0, 0.0};
  const Gated gated = gate(kHands, open(), asked, 1e-3);
  EXPECT_EQ(gated.force.f_T_W(), kZero);
  EXPECT_EQ(gated.next.fault.kind, FaultKind::TooFast);
  EXPECT_EQ(gated.next.fault.seen, 25.0);
  EXPECT_EQ(gated.next.fault.allowed, 20.0);
  asked.motion.v_WT = {0.0, 19.9, 0.0};
  EXPECT_EQ(gate(kHands, open(), asked, 1e-3).next.fault.kind, FaultKind::None);
}

TEST(Edge, AForceTowardsAStopFadesAndOneAwayFromItDoesNot) {
  Motion motion = levers();
  motion.joints[0].room_above_rad = 0.025;  // half of 0.05
  const Vec3 towards(0.4, 0.2, 0.0), away(-0.4, 0.2, 0.0);
  EXPECT_LT((limitEdge(motion, towards) - 0.5 * towards).norm(), 1e-16);
  EXPECT_EQ(limitEdge(motion, away), away);
  motion.joints[0].room_above_rad = -0.01;  // beyond it already
  EXPECT_EQ(limitEdge(motion, towards), kZero);
  EXPECT_EQ(limitEdge(motion, away), away);
  motion.joints[0].room_above_rad = kInfinity;
  motion.joints[0].room_below_rad = 0.01;
  EXPECT_LT((limitEdge(motion, away) - 0.2 * away).norm(), 1e-16);
}

TEST(Heat, RisesToTheSquareOfTheLoadAndFallsAgain) {
  Heat heat{};
  for (int tick = 0; tick < 60'000; ++tick) heat = heated(kHands.thermal, heat, levers(), {{0.5, 0, 0}, kZero}, 1e-3);
  // One time constant at half of what motor 1 bears (0.075 of 0.15 N m): a quarter of (1 - 1/e); Euler adds 1e-5.
  EXPECT_NEAR(heat[0], 0.25 * (1.0 - std::exp(-1.0)), 1e-5);
  EXPECT_EQ(heat[1], 0.0);
  for (int tick = 0; tick < 60'000; ++tick) heat = heated(kHands.thermal, heat, levers(), {}, 1e-3);
  EXPECT_NEAR(heat[0], 0.25 * (1.0 - std::exp(-1.0)) * std::exp(-1.0), 1e-5);
}

TEST(Heat, NeverGoesBeyondOneWhateverIsAsked) {  // motor 3 bears 0.10 N m and is asked for 0.132
  GateState state = open();
  GateInput asked = push({0.0, 0.0, 0.88});
  asked.motion = levers();
  double worst = 0.0, last_N = 0.0;
  bool was_cut = false;
  for (int tick = 0; tick < 600'000; ++tick) {
    const Gated gated = gate(kHands, state, asked, 1e-3);
    state = gated.next;
    worst = std::max(worst, state.heat[2]);
    was_cut |= gated.cuts.heat_N > 0.0;
    last_N = gated.force.f_T_W().z();
  }
  EXPECT_LE(worst, 1.0 + 1e-12);
  EXPECT_TRUE(was_cut);
  EXPECT_NEAR(last_N, 0.10 / 0.15, 0.01);  // ends at what the motor bears for good
}

TEST(Heat, IsNotForgottenByARestart) {
  GateState state = open();
  state.heat = {0.5, 0.6, 0.7};
  GateInput asked = push({0.1, 0.0, 0.0});
  asked.restart = true;
  EXPECT_EQ(gate(kHands, state, asked, 0.0).next.heat, (Heat{0.5, 0.6, 0.7}));
}

TEST(Heat, CoolsWhileAFaultLasts) {
  Limits limits = kHands;
  limits.thermal.continuous_N_m.back() = 0.1;  // of an arm that drives eight joints
  GateState state = open();
  state.heat.front() = state.heat.back() = 0.5;
  state.fault = {FaultKind::NotFinite, 0.0, 0.0};
  const Heat next = gate(limits, state, push(kZero), 1e-3).next.heat;
  EXPECT_LT(next.front(), 0.5);
  EXPECT_LT(next.back(), 0.5);
}

TEST(Slew, AStepBecomesARampOfOneNewtonAMillisecondAtAnyRate) {
  for (const double dt_s : {1e-3, 2.5e-4, 1e-4}) {
    Gated gated = gate(kHands, open(), push({-0.8, 0.0, 0.0}), 1.0);
    ASSERT_EQ(gated.force.f_T_W(), Vec3(-0.8, 0.0, 0.0));
    double before_N = -0.8;
    for (double t_s = dt_s; t_s < 2e-3 + 0.5 * dt_s; t_s += dt_s) {
      gated = gate(kHands, gated.next, push({0.8, 0.0, 0.0}), dt_s);
      EXPECT_LE(gated.force.f_T_W().x() - before_N, 1000.0 * dt_s * (1 + 1e-12)) << dt_s;
      EXPECT_NEAR(gated.force.f_T_W().x(), std::min(0.8, -0.8 + 1000.0 * t_s), 1e-12);
      before_N = gated.force.f_T_W().x();
    }
    EXPECT_EQ(gated.force.f_T_W().x(), 0.8);
  }
}

TEST(Slew, DoesNotHoldAFaultBack) {
  Gated gated = gate(kHands, open(), push({0.8, 0.0, 0.0}), 1.0);
  gated = gate(kHands, gated.next, push({kNotANumber, 0.0, 0.0}), 1e-4);
  EXPECT_EQ(gated.force.f_T_W(), kZero);
}

TEST(Frozen, ASampleThatStaysTheSameToTheBitIsLetGoUntilItMoves) {
  Limits limits = kHands;
  limits.frozen_s = 0.5;
  GateState state = open();
  GateInput asked = push({0.1, 0.0, 0.0});
  asked.motion.moved = false;
  Gated gated;
  for (int tick = 0; tick < 499; ++tick) gated = gate(limits, state, asked, 1e-3), state = gated.next;
  EXPECT_FALSE(gated.cuts.frozen);
  EXPECT_EQ(gated.next.level, 1.0);
  for (int tick = 0; tick < 60; ++tick) gated = gate(limits, state, asked, 1e-3), state = gated.next;
  EXPECT_TRUE(gated.cuts.frozen);
  EXPECT_EQ(gated.force.f_T_W(), kZero) << "softly, in 50 ms";
  EXPECT_EQ(gated.fault.kind, FaultKind::None) << "an arm laid down is no fault";
  asked.motion.moved = true;
  for (int tick = 0; tick < 310; ++tick) gated = gate(limits, state, asked, 1e-3), state = gated.next;
  EXPECT_EQ(gated.next.level, 1.0);
}

TEST(Late, TwentyInARowAreBorneAndOneMoreLetsGoSoftlyThenStops) {
  GateState state = open();
  GateInput late = push({0.5, 0.0, 0.0});
  late.late = true;
  Gated gated;
  for (int tick = 0; tick < 20; ++tick) gated = gate(kHands, state, late, 2e-3), state = gated.next;
  EXPECT_EQ(gated.next.level, 1.0);
  double before_N = 0.5;
  for (int tick = 0; tick < 25; ++tick) {
    gated = gate(kHands, state, late, 2e-3), state = gated.next;
    EXPECT_LT(gated.force.f_T_W().x(), before_N);
    EXPECT_LE(before_N - gated.force.f_T_W().x(), 0.5 * 2.0 / 50 + 1e-12);
    before_N = gated.force.f_T_W().x();
  }
  EXPECT_EQ(gated.force.f_T_W(), kZero);
  gated = gate(kHands, state, push({0.5, 0.0, 0.0}), 1e-3);
  EXPECT_EQ(gated.next.fault.kind, FaultKind::TooLate) << "being on time again does not take it back";
  EXPECT_EQ(gated.next.fault.seen, 21.0);
  EXPECT_EQ(gated.force.f_T_W(), kZero);
}

TEST(Late, OneOnTimeStartsTheCountAgain) {
  GateState state = open();
  for (int tick = 0; tick < 1000; ++tick) {
    GateInput asked = push({0.5, 0.0, 0.0});
    asked.late = tick % 21 != 20;
    state = gate(kHands, state, asked, 1e-3).next;
  }
  EXPECT_EQ(state.level, 1.0);
}

TEST(Late, IsNoFaultWhileNothingPushes) {
  GateState state;
  for (int tick = 0; tick < 100; ++tick) {
    GateInput idle;
    idle.late = true;
    state = gate(kHands, state, idle, 1e-3).next;
  }
  EXPECT_EQ(state.fault.kind, FaultKind::None);
  EXPECT_EQ(state.late, 0);
}

TEST(Stages, NoneMakesAForceLargerOrNotFinite) {
  test::Random random(test::Seed{20261121});
  const double odd[] = {0.0, -0.0, 5e-324, 1e-200, 1e200, -1.7e308, kInfinity, -kInfinity, kNotANumber};
  for (int draw = 0; draw < test::sweep(100'000, 5'000'000); ++draw) {
    const auto any = [&](double size) {
      return random.below(8) == 0 ? odd[random.below(9)] : random.between(-size, size);
    };
    const Vec3 f(random.between(-0.5, 0.5), random.between(-0.5, 0.5), random.between(-0.5, 0.5));
    Mat3 J_p;
    for (int at = 0; at < 9; ++at) J_p(at / 3, at % 3) = any(0.3);
    Motion motion = threeJoints(J_p);
    motion.v_WT = {any(4), any(4), any(4)};
    for (std::size_t joint = 0; joint < 3; ++joint)
      motion.joints[joint].room_above_rad = any(0.1), motion.joints[joint].room_below_rad = any(0.1);
    const Heat heat{random.between(0.8, 1.1), random.between(0.8, 1.1), random.between(0.8, 1.1)};
    const double dt_s = any(0.01);
    const Vec3 v = followVelocity({any(4), 0.0, 0.0}, motion.v_WT, dt_s);
    EXPECT_TRUE(v.allFinite() || !(dt_s > 0.0));
    for (const Vec3& limited :
         {limitSpeed(kHands, v, f), limitEdge(motion, f), Vec3(torqueShare(kHands, heat, motion, {f, kZero}) * f)}) {
      ASSERT_TRUE(limited.allFinite()) << draw;
      ASSERT_LE(limited.norm(), f.norm() * (1 + 1e-15)) << draw;
    }
    ASSERT_LE(limitSlew(kHands, f, -f, std::abs(dt_s)).norm(), f.norm() * (1 + 1e-15));
    for (const double warm : heated(kHands.thermal, heat, motion, {f, kZero}, dt_s))
      ASSERT_TRUE(std::isfinite(warm)) << draw;
  }
}

TEST(Cuts, AreBitsInTheOrderInWhichTheyAct) {
  EXPECT_EQ(bitsOf({}), 0U);
  EXPECT_EQ(bitsOf({1, 0, 0, 0, 0, false}), 1U);
  EXPECT_EQ(bitsOf({0, 1, 1, 0, 0, false}), 6U);
  EXPECT_EQ(bitsOf({0, 0, 0, 1, 1, true}), 56U);
  EXPECT_EQ(sumOf({1, 2, 3, 4, 5, true}), 15.0);
  EXPECT_TRUE(std::isfinite(sumOf({1.7e308, 1.7e308, 0, 0, 0, false})));
}

}  // namespace underact::safety
