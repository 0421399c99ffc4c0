#include "core/control/law.h"

#include <cmath>

#include "tests/core/control/tick.h"
#include "tests/support/property.h"

namespace underact::control {
namespace {

LawInput after(double dt_s) {
  return {dt_s, false, false};
}

TEST(LawP, IsTheGainTimesTheErrorAxisByAxis) {
  LawState state;
  EXPECT_EQ(force(P{{100, 200, 300}}, state, {0.01, -0.02, 0.03}, after(0.0)), Vec3(1.0, -4.0, 9.0));
  EXPECT_FALSE(state.velocity.has_last);  // untouched
}

TEST(LawPD, ByHand) {  // kp 100, kd 2, dt = the filter's time constant, so half of the new rate comes through
  const PD law{Vec3::Constant(100.0), Vec3::Constant(2.0)};
  LawState state;
  EXPECT_EQ(force(law, state, {0.010, 0, 0}, after(0.0)).x(), 1.0);  // the first tick knows no rate
  // Raw rate 0.002 / 0.0016 = 1.25 m/s, filtered 0.625: 100 * 0.012 + 2 * 0.625.
  EXPECT_NEAR(force(law, state, {0.012, 0, 0}, after(kRateFilter_s)).x(), 1.2 + 1.25, 1e-14);
  // Stands still: half of it again.
  EXPECT_NEAR(force(law, state, {0.012, 0, 0}, after(kRateFilter_s)).x(), 1.2 + 0.625, 1e-14);
  EXPECT_EQ(state.velocity.rate_W.y(), 0.0);
}

TEST(LawPD, TheRateFollowsAStepAsAFirstOrderFilter) {  // after n ticks 1 - (tau / (tau + dt))^n of it
  const PD law{kZero, {1, 1, 1}};
  LawState state;
  for (int n = 0; n <= 20; ++n) {
    const double e_m = 0.2 * kTick_s * n;  // 0.2 m/s from the first tick on
    const double right = 0.2 * (1.0 - std::pow(kRateFilter_s / (kRateFilter_s + kTick_s), n));
    // e_last - e loses ulp(0.004) = 9e-19 m, over 1 ms.
    ASSERT_NEAR(force(law, state, {e_m, -e_m, 0}, after(n == 0 ? 0.0 : kTick_s)).x(), right, 1e-14) << n;
  }
  EXPECT_NEAR(state.velocity.rate_W.y(), -state.velocity.rate_W.x(), 0.0);
}

TEST(LawPD, NoKickAtTheFirstTick) {
  const PD law{Vec3::Constant(100.0), Vec3::Constant(50.0)};
  LawState state;
  EXPECT_EQ(force(law, state, {0.05, 0, 0}, after(0.0)).x(), 5.0);
  LawState late;  // even where the first tick of the law is not the first of the servo
  EXPECT_EQ(force(law, late, {0.05, 0, 0}, after(kTick_s)).x(), 5.0);
}

TEST(LawPD, AtContactTheRateIsThatOfTheHandNotAJump) {
  const PD law{kZero, {1, 1, 1}};
  LawState state;
  rest(state, false);  // an untouched wall: error zero
  // 0.1 m/s into the wall: 0.1 mm deep at the first tick. The filter lets dt / (dt + tau) of it through.
  EXPECT_NEAR(force(law, state, {1e-4, 0, 0}, after(kTick_s)).x(), 0.1 * kTick_s / (kTick_s + kRateFilter_s), 1e-15);
}

TEST(LawPD, AfterALostTargetTheRateStartsAnew) {
  const PD law{kZero, {1, 1, 1}};
  LawState state;
  (void)force(law, state, {0.01, 0, 0}, after(0.0));
  (void)force(law, state, {0.02, 0, 0}, after(kTick_s));
  EXPECT_GT(state.velocity.rate_W.x(), 1.0);
  rest(state, true);
  EXPECT_EQ(force(law, state, {-0.02, 0, 0}, after(kTick_s)),
            kZero);  // through the centre: the error jumps, the hand does not
}

const PID kPid{Vec3::Constant(100.0), kZero, Vec3::Constant(10.0), 0.5};

TEST(LawPID, ByHand) {  // ki 10 N/(m s), 0.01 m, 1 ms: 1e-4 N a tick
  LawState state;
  EXPECT_EQ(force(kPid, state, {0.01, 0, -0.02}, after(0.0)), Vec3(1.0, 0.0, -2.0));
  EXPECT_NEAR(force(kPid, state, {0.01, 0, -0.02}, after(kTick_s)).x(), 1.0001, 1e-15);
  const Vec3 f = force(kPid, state, {0.01, 0, -0.02}, after(kTick_s));
  EXPECT_NEAR(f.x(), 1.0002, 1e-15);
  EXPECT_NEAR(f.z(), -2.0004, 1e-15);
  EXPECT_EQ(f.y(), 0.0);
}

TEST(LawPID, TheIntegralStaysWithinItsLimitWithItsDirectionKept) {
  LawState state;
  for (int n = 0; n < 20000; ++n) {
    (void)force(kPid, state, {0.03, 0.04, 0.0}, after(kTick_s));
    ASSERT_LE(state.integral_T_W.norm(), 0.5 * (1 + 4 * 0x1p-52));
  }
  EXPECT_NEAR(state.integral_T_W.x(), 0.3, 1e-12);
  EXPECT_NEAR(state.integral_T_W.y(), 0.4, 1e-12);
}

TEST(LawPID, WhileTheGateCutsItDoesNotGrow) {
  LawState state;
  (void)force(kPid, state, {0.01, 0, 0}, after(kTick_s));
  const double before_N = state.integral_T_W.x();
  for (int n = 0; n < 1000; ++n) (void)force(kPid, state, {0.01, 0, 0}, {kTick_s, true, false});
  EXPECT_EQ(state.integral_T_W.x(), before_N);
}

TEST(LawPID,
     WhileTheGateCutsItStillGrowsOnTheAxisThatHelps) {  // the added part is against the force: it lessens the cut
  LawState state;
  state.integral_T_W = {0.4, 0, 0};
  const PID weak{kZero, kZero, Vec3::Constant(10.0), 0.5};
  (void)force(weak, state, {-0.01, 0, 0}, {kTick_s, true, false});
  EXPECT_NEAR(state.integral_T_W.x(), 0.3999, 1e-15);
}

TEST(LawPID, WhileTheGateCutsItIsTheWholeForceThatCounts) {  // the spring already pulls back, the integral still pushes
  LawState state;
  state.integral_T_W = {0.4, 0, 0};
  (void)force(kPid, state, {-0.001, 0, 0}, {kTick_s, true, false});
  EXPECT_NEAR(state.integral_T_W.x(), 0.4 - 10.0 * 0.001 * kTick_s, 1e-15);
}

TEST(LawPID, RecoversAtOnceFromACut) {  // without anti-windup the 10 s push would take 10 s to unwind
  LawState state;
  for (int n = 0; n < 10000; ++n) (void)force(kPid, state, {0.04, 0, 0}, {kTick_s, true, false});
  EXPECT_LE(force(kPid, state, {-0.001, 0, 0}, after(kTick_s)).x(), 0.0);
}

TEST(LawPID, AChangeOfKiMakesNoJump) {
  LawState state;
  for (int n = 0; n < 2000; ++n) (void)force(kPid, state, {0.01, 0, 0}, after(kTick_s));
  const double before_N = force(kPid, state, {0.01, 0, 0}, after(kTick_s)).x();
  PID stronger = kPid;
  stronger.ki_N_per_m_s *= 100.0;
  EXPECT_NEAR(force(stronger, state, {0.01, 0, 0}, after(kTick_s)).x(), before_N + 1000.0 * 0.01 * kTick_s, 1e-15);
}

TEST(LawPID, IsEmptyWhileTheServoIsIdle) {
  LawState state;
  state.integral_T_W = {0.1, 0.2, 0.3};
  EXPECT_EQ(force(kPid, state, {0.01, 0, 0}, {kTick_s, false, true}).x(), 1.0);
  EXPECT_EQ(state.integral_T_W, kZero);
}

TEST(LawRest, AnUntouchedWallForgetsALostTargetKeepsTheIntegral) {
  LawState state;
  state.integral_T_W = {0.1, 0, 0};
  state.velocity.rate_W = {1, 0, 0};
  state.velocity.e_last_W = {1, 0, 0};
  LawState lost = state;
  rest(state, false);
  EXPECT_EQ(state.integral_T_W, kZero);
  EXPECT_EQ(state.velocity.rate_W, kZero);
  EXPECT_EQ(state.velocity.e_last_W, kZero);
  EXPECT_TRUE(state.velocity.has_last);
  rest(lost, true);
  EXPECT_EQ(lost.integral_T_W, Vec3(0.1, 0, 0));
  EXPECT_EQ(lost.velocity.rate_W, kZero);
  EXPECT_FALSE(lost.velocity.has_last);
}

TEST(Law, SaysWhatItNeeds) {
  EXPECT_FALSE(needsRate(P{}));
  EXPECT_TRUE(needsRate(PD{}));
  EXPECT_TRUE(needsRate(PID{}));
  EXPECT_FALSE(needsIntegral(P{}));
  EXPECT_FALSE(needsIntegral(PD{}));
  EXPECT_TRUE(needsIntegral(PID{}));
  for (const Law& law : {Law(P{{1, 2, 3}}), Law(PD{{1, 2, 3}, kZero}), Law(PID{{1, 2, 3}, kZero, kZero, 1.0})}) {
    EXPECT_EQ(stiffness(law), Vec3(1, 2, 3));
  }
}

TEST(Law, WithoutItsGainsEachIsTheOneBefore) {  // PD with kd 0 is P, PID with ki 0 is PD, bit for bit
  test::Random random(test::Seed{20070901});
  LawState p, pd, pd2, pid;
  const Vec3 kp(100, 200, 300), kd(1, 2, 3);
  for (int n = 0; n < 2000; ++n) {
    const Vec3 e_W = random.inBox(0.05);
    ASSERT_EQ(force(P{kp}, p, e_W, after(kTick_s)), force(PD{kp, kZero}, pd, e_W, after(kTick_s)));
    ASSERT_EQ(force(PD{kp, kd}, pd2, e_W, after(kTick_s)), force(PID{kp, kd, kZero, 1.0}, pid, e_W, after(kTick_s)));
  }
}

TEST(Law, FiniteInFiniteOut) {
  test::Random random(test::Seed{20070902});
  LawState state;
  for (int n = 0; n < test::sweep(20000, 1000000); ++n) {
    const auto any = [&] { return std::pow(10.0, random.between(-30.0, 12.0)); };
    const PID law{Vec3(any(), any(), any()), Vec3(any(), any(), any()), Vec3(any(), any(), any()), any()};
    const LawInput moment{random.below(10) == 0 ? 0.0 : random.between(1e-9, 0.1), random.below(2) == 0,
                          random.below(50) == 0};
    const Vec3 f = force(law, state, any() * random.direction(), moment);
    ASSERT_TRUE(f.allFinite());
    ASSERT_TRUE(state.integral_T_W.allFinite() && state.velocity.rate_W.allFinite());
    if (random.below(20) == 0) rest(state, random.below(2) == 0);
  }
}

}  // namespace
}  // namespace underact::control
