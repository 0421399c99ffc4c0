#include "core/safety/gate.h"

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "tests/core/safety/pushed.h"
#include "tests/support/constraint_vectors.h"
#include "tests/support/property.h"

namespace underact::safety {
namespace {

static_assert(!std::is_constructible_v<GatedForce, Vec3>, "only gate() may make a force that is not zero");
static_assert(!std::is_convertible_v<Vec3, GatedForce> && !std::is_assignable_v<GatedForce&, Vec3>);
static_assert(!std::is_aggregate_v<GatedForce>);
static_assert(noexcept(gate(std::declval<const Limits&>(), std::declval<const GateState&>(),
                            std::declval<const GateInput&>(), 0.0)));
static_assert(noexcept(clampForce(std::declval<const Vec3&>(), 0.0)) && noexcept(std::declval<GatedForce&>().f_T_W()));

constexpr double kUlp = 0x1p-52;
const Limits kLimits{0.88};
const Vec3 kSmall{0.1, -0.2, 0.3};

TEST(GatedForce, IsZeroUntilAGateMakesIt) {
  EXPECT_EQ(GatedForce{}.f_T_W(), kZero);
}

TEST(Clamp, Golden) {
  ASSERT_EQ(test::constraintVectors().clamp.size(), 7U);
  for (const test::GoldenClamp& one : test::constraintVectors().clamp) {
    // The file's numbers are exact to their last digit; ours is a quotient, a root and a product: 4 ulp.
    EXPECT_LE((clampForce(one.force, one.max) - one.clamped).cwiseAbs().maxCoeff(), 4 * kUlp * one.max)
        << one.force.transpose();
  }
}

TEST(Clamp, LeavesWhatIsWithinAloneToTheLastBit) {
  for (const Vec3& f : {kSmall, Vec3(0.88, 0, 0), Vec3(0, -0.5, 0.5), Vec3(1e-200, 0, 0), Vec3(5e-324, 5e-324, 0)}) {
    EXPECT_EQ(clampForce(f, 0.88), f);
  }
}

TEST(Clamp, SendsZeroForAForceThatIsNotFinite) {
  for (const double bad : {kNotANumber, kInfinity, -kInfinity}) {
    EXPECT_EQ(clampForce({bad, 0, 0}, 0.88), kZero);
    EXPECT_EQ(clampForce({0, bad, 0}, 0.88), kZero);
    EXPECT_EQ(clampForce({0, 1, bad}, 0.88), kZero);
  }
}

TEST(Clamp, ALimitThatIsNoLimitLetsNothingThrough) {
  for (const double limit : {0.0, -1.0, kNotANumber}) EXPECT_EQ(clampForce({1, 2, 3}, limit), kZero) << limit;
}

TEST(Clamp, NeverAboveTheLimitAndInTheSameDirection) {
  test::Random random(test::Seed{20071001});
  for (int draw = 0; draw < test::sweep(20000, 1000000); ++draw) {
    const double size = std::pow(10.0, random.between(-320.0, 308.2));
    const double max_N = std::pow(10.0, random.between(-6.0, 3.0));
    const Vec3 direction = random.direction(), f = size * direction;
    const Vec3 clamped = clampForce(f, max_N);
    ASSERT_LE(clamped.norm(), max_N * (1 + 4 * kUlp)) << f.transpose();
    if (size > max_N * (1 + 4 * kUlp)) {
      ASSERT_GE(clamped.norm(), max_N * (1 - 8 * kUlp)) << f.transpose();
    }
    if (size > 1e-290) {
      ASSERT_LE((clamped.stableNormalized() - direction).norm(), 8 * kUlp) << f.transpose();
    }
  }
  const double max = std::numeric_limits<double>::max();
  EXPECT_NEAR(clampForce({max, -max, max}, 0.88).norm(), 0.88, 4 * kUlp);
}

TEST(Gate, OpenAndEngagedTheForcePassesAsItIs) {
  const Gated gated = gate(kLimits, open(), push(kSmall), 1e-3);
  EXPECT_EQ(gated.force.f_T_W(), kSmall);
  EXPECT_EQ(sumOf(gated.cuts), 0.0);
  EXPECT_EQ(gated.fault.kind, FaultKind::None);
  EXPECT_EQ(gated.next.level, 1.0);
}

TEST(Gate, SaysHowMuchItCut) {
  EXPECT_NEAR(gate(kLimits, open(), push({3, 4, 0}), 1e-3).cuts.clamp_N, 5.0 - 0.88, 1e-15);
  EXPECT_TRUE(std::isfinite(sumOf(gate(kLimits, open(), push(Vec3::Constant(1.7e308)), 1e-3).cuts)));
}

TEST(Gate, TheForceRisesInTheRiseTimeAndFallsInTheFallTime) {
  GateState state;
  for (int tick = 1; tick <= 300; ++tick) {
    const Gated gated = gate(kLimits, state, push(kSmall), 1e-3);
    state = gated.next;
    ASSERT_NEAR(state.level, tick / 300.0, 1e-13) << tick;  // 300 sums of 1 ulp
    ASSERT_LE((gated.force.f_T_W() - state.level * kSmall).norm(), kUlp) << tick;
  }
  (void)gate(kLimits, state, push(kSmall), 1e-3);
  EXPECT_NEAR(state.level, 1.0, 1e-13);
  GateInput release = push(kSmall);
  release.engage = false;
  state.level = 1.0;
  for (int tick = 1; tick <= 60; ++tick) {
    state = gate(kLimits, state, release, 1e-3).next;
    ASSERT_NEAR(state.level, std::max(0.0, 1.0 - tick / 50.0), 1e-13) << tick;
  }
  EXPECT_EQ(state.level, 0.0);
  EXPECT_EQ(gate(kLimits, state, release, 1e-3).force.f_T_W(), kZero);
}

TEST(Gate, ARampGoesByTimeNotByTicks) {
  GateState slow, fast;
  slow = gate(kLimits, slow, push(kSmall), 0.1).next;
  for (int tick = 0; tick < 400; ++tick) fast = gate(kLimits, fast, push(kSmall), 0.25e-3).next;
  EXPECT_NEAR(slow.level, fast.level, 1e-13);
}

TEST(Gate, WithoutARampTheLevelJumpsAndIsNeverNotANumber) {
  const Limits limits{0.88, 0.0, 0.0};
  const Gated first = gate(limits, {}, push(kSmall), 0.0);  // 0 / 0
  EXPECT_TRUE(first.force.f_T_W().allFinite());
  const Gated second = gate(limits, first.next, push(kSmall), 1e-3);
  EXPECT_EQ(second.next.level, 1.0);
  EXPECT_EQ(gate(limits, second.next, {kSmall, false, false, {}}, 1e-3).next.level, 0.0);
}

TEST(Gate, ARampThatIsNoTimeIsAJumpToo) {
  for (const double ramp_s : {-1.0, kNotANumber}) {
    const Limits limits{0.88, ramp_s, ramp_s};
    EXPECT_EQ(gate(limits, {}, push(kSmall), 1e-3).next.level, 1.0);
    EXPECT_EQ(gate(limits, open(), {kSmall, false, false, {}}, 1e-3).next.level, 0.0);
  }
}

TEST(Gate, TimeThatGoesBackOrIsNotANumberMovesNoRampUp) {
  for (const double dt_s : {-1.0, kNotANumber, -kInfinity}) {
    GateState state;
    state.level = 0.5;
    EXPECT_LE(gate(kLimits, state, push(kSmall), dt_s).next.level, 0.5) << dt_s;
    EXPECT_LE(gate(kLimits, state, {kSmall, false, false, {}}, dt_s).next.level, 0.5) << dt_s;
  }
}

TEST(Gate, AForceThatIsNotANumberGivesZeroAndAFaultThatLasts) {
  for (const double bad : {kNotANumber, kInfinity, -kInfinity}) {
    Gated gated = gate(kLimits, open(), push({0, bad, 0}), 1e-3);
    EXPECT_EQ(gated.force.f_T_W(), kZero);
    EXPECT_EQ(gated.fault.kind, FaultKind::NotFinite);
    EXPECT_EQ(gated.next.level, 0.0);
    for (int tick = 0; tick < 100; ++tick) {
      gated = gate(kLimits, gated.next, push(kSmall), 1e-3);
      ASSERT_EQ(gated.force.f_T_W(), kZero);
      ASSERT_EQ(gated.fault.kind, FaultKind::NotFinite);
    }
  }
}

TEST(Gate, RestartClearsAFaultAndRampsFromNothing) {
  Gated gated = gate(kLimits, open(), push({0, kNotANumber, 0}), 1e-3);
  GateInput restart = push(kSmall);
  restart.restart = true;
  gated = gate(kLimits, gated.next, restart, 1e-3);
  EXPECT_EQ(gated.fault.kind, FaultKind::None);
  EXPECT_NEAR(gated.next.level, 1e-3 / 0.3, 1e-17);
  gated = gate(kLimits, gated.next, push(kSmall), 1e-3);
  EXPECT_NEAR(gated.next.level, 2e-3 / 0.3, 1e-17);
}

TEST(Gate, RestartForgetsTheSpeedToo) {  // a speed of before would cut the first forces after Start
  GateState fast = open();
  fast.v_WT = Vec3(19.0, 0, 0);
  fast.heat = {0.1, 0.2, 0.3};
  GateState cold;
  cold.heat = fast.heat;
  GateInput restart = push({0.5, 0, 0});
  restart.restart = true;
  const Limits limits = limitsForHands(0.88, Vec3::Zero());
  const Gated gated = gate(limits, fast, restart, 1e-3);
  EXPECT_EQ(gated.next.v_WT, kZero);
  EXPECT_EQ(gated.force.f_T_W(), gate(limits, cold, restart, 1e-3).force.f_T_W());
  EXPECT_EQ(gated.next.heat, fast.heat) << "motors cool by time alone";
}

TEST(Gate, RestartDoesNotHideWhatIsWrongNow) {
  GateInput restart = push({kNotANumber, 0, 0});
  restart.restart = true;
  EXPECT_EQ(gate(kLimits, open(), restart, 1e-3).next.fault.kind, FaultKind::NotFinite);
}

TEST(Gate, AMissingSampleIsZeroForceAndTooManyAreAFaultThatLasts) {
  for (const FaultKind kind : {FaultKind::NoSample, FaultKind::StaleSample}) {
    const GateInput missing{kZero, true, false, {kind, 0.0, 0.0}};
    GateState state = open();
    for (int tick = 1; tick <= 20; ++tick) {
      const Gated gated = gate(kLimits, state, missing, 0.0);
      state = gated.next;
      ASSERT_EQ(gated.force.f_T_W(), kZero);
      ASSERT_EQ(gated.fault.kind, kind) << "the tick says why it is zero";
      ASSERT_EQ(state.fault.kind, FaultKind::None) << tick;
      ASSERT_EQ(state.missed, tick);
      ASSERT_EQ(state.level, 0.0);
    }
    EXPECT_EQ(gate(kLimits, state, push(kSmall), 1e-3).next.fault.kind, FaultKind::None) << "it came back in time";
    EXPECT_EQ(gate(kLimits, state, push(kSmall), 1e-3).next.missed, 0);
    const Gated last = gate(kLimits, state, missing, 0.0);  // the 21st
    EXPECT_EQ(last.next.fault.kind, kind);
    const Gated later = gate(kLimits, last.next, push(kSmall), 1e-3);
    EXPECT_EQ(later.force.f_T_W(), kZero);
    EXPECT_EQ(later.fault.kind, kind);
  }
}

TEST(Gate, TheFaultOfMissingSamplesSaysHowMany) {
  GateState state = open();
  for (int tick = 0; tick < 21; ++tick)
    state = gate(kLimits, state, {kZero, true, false, {FaultKind::NoSample, 0, 0}}, 0.0).next;
  EXPECT_EQ(state.fault.seen, 21.0);
  EXPECT_EQ(state.fault.allowed, 20.0);
}

TEST(Gate, TheFirstFaultIsTheOneThatIsKept) {
  Gated gated = gate(kLimits, open(), push({kNotANumber, 0, 0}), 1e-3);
  for (int tick = 0; tick < 50; ++tick)
    gated = gate(kLimits, gated.next, {kZero, true, false, {FaultKind::NoSample, 0, 0}}, 0.0);
  EXPECT_EQ(gated.fault.kind, FaultKind::NotFinite);
}

TEST(Gate, CountsMissingSamplesWithoutEnd) {  // an hour at 4 kHz, and no count runs over
  GateState state = open();
  for (int tick = 0; tick < 100000; ++tick)
    state = gate(kLimits, state, {kZero, true, false, {FaultKind::NoSample, 0, 0}}, 0.0).next;
  EXPECT_LE(state.missed, 21);
}

TEST(Gate, WhateverComesInTheForceIsFiniteWithinItsLimitAndZeroInAFault) {
  test::Random random(test::Seed{20071002});
  const std::vector<double> odd{0.0,   -0.0,    5e-324,   1e-200,    0.1,        -0.88,      3.0,
                                1e200, 1.7e308, -1.7e308, kInfinity, -kInfinity, kNotANumber};
  GateState state;
  for (int draw = 0; draw < test::sweep(200000, 10000000); ++draw) {
    const auto any = [&] { return random.below(4) == 0 ? odd[random.below(odd.size())] : random.between(-2.0, 2.0); };
    GateInput asked{{any(), any(), any()}, random.below(10) != 0, random.below(10) == 0, {}};
    if (random.below(10) == 0) asked.fault.kind = static_cast<FaultKind>(random.below(kFaultKinds));
    Limits limits = random.below(2) == 0 ? kLimits : limitsForHands(0.88, Vec3(0.15, 0.15, 0.0));
    limits.max_force_N = random.between(0.0, 3.0);
    asked.late = random.below(3) != 0;
    asked.motion.moved = random.below(2) == 0;
    Mat3 J_p;
    for (int at = 0; at < 9; ++at) J_p(at / 3, at % 3) = any();
    const bool moved = asked.motion.moved;
    asked.motion = threeJoints(J_p);
    asked.motion.moved = moved;
    asked.motion.v_WT = {any(), any(), any()};
    for (std::size_t joint = 0; joint < 3; ++joint) asked.motion.joints[joint].room_above_rad = any();
    const Gated gated = gate(limits, state, asked, random.between(0.0, 0.05));
    const Vec3 f = gated.force.f_T_W();
    ASSERT_TRUE(f.allFinite());
    ASSERT_LE(f.norm(), limits.max_force_N * (1 + 4 * kUlp));
    if (gated.fault.kind != FaultKind::None || gated.next.fault.kind != FaultKind::None) {
      ASSERT_EQ(f, kZero);
    }
    ASSERT_TRUE(gated.next.level >= 0.0 && gated.next.level <= 1.0);
    ASSERT_TRUE(std::isfinite(sumOf(gated.cuts)) && sumOf(gated.cuts) >= 0.0);
    state = gated.next;
  }
}

}  // namespace
}  // namespace underact::safety
