#include "core/tick/step.h"

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "core/arm/forward.h"
#include "tests/support/constraint_vectors.h"
#include "tests/support/tick_hand.h"

namespace underact::tick {
namespace {

using control::P;
using control::PD;
using control::PID;
using target::Side;
using test::Hand;
using test::hold;

static_assert(noexcept(step(std::declval<const TickProgram&>(), std::declval<const TickInput&>(),
                            std::declval<TickState&>(), std::declval<TickReport&>())));
static_assert(std::is_nothrow_copy_constructible_v<ConstraintReports> &&
              std::is_nothrow_copy_assignable_v<ConstraintReports>);

const Vec3 kZero = Vec3::Zero();
const Vec3 kAway{0.03, 0.05, 0.06};
const P kWeak{Vec3::Constant(10.0)};  // under the clamp everywhere in reach
const shape::Shape kPoint = shape::makePoint({0.01, 0.02, 0.03}, {}).value();
const shape::Shape kFloor = shape::makePlane({0, 0, 0}, {0, 1, 0}, {}).value();

TEST(Needs, AreThoseOfTheSceneAndNoOthers) {
  const auto needsOf = [](std::vector<Entry> entries, Combine combine = Combine::Sum) {
    return makeProgram(test::thesisGeometry(), std::move(entries), combine, test::kTestLimits).needs;
  };
  const Needs point = needsOf({hold(kPoint, kWeak)});
  EXPECT_FALSE(point.rate || point.integral || point.metric || point.choice);
  EXPECT_TRUE(needsOf({hold(kPoint, PD{})}).rate);
  EXPECT_FALSE(needsOf({hold(kPoint, PD{})}).integral);
  EXPECT_TRUE(needsOf({hold(kPoint, PID{})}).rate);
  EXPECT_TRUE(needsOf({hold(kPoint, PID{})}).integral);
  EXPECT_TRUE(needsOf({hold(kFloor, P{{1, 2, 3}})}).metric);
  EXPECT_FALSE(needsOf({hold(kPoint, P{{1, 2, 3}})}).metric);
  EXPECT_FALSE(needsOf({hold(kPoint, kWeak)}, Combine::Nearest).choice) << "one has nothing to choose from";
  EXPECT_TRUE(needsOf({hold(kPoint, kWeak), hold(kFloor, kWeak)}, Combine::Nearest).choice);
  EXPECT_TRUE(needsOf({hold(kPoint, kWeak), hold(kFloor, PD{})}).rate) << "any of them";
}

TEST(Needs, ALawWithoutMemoryHasNone) {
  EXPECT_EQ(bytesOf(Hand({hold(kPoint, kWeak)}, Combine::Sum).state()), sizeof(TickState));
  EXPECT_EQ(bytesOf(Hand({hold(kPoint, kWeak), hold(kFloor, PD{})}, Combine::Sum).state()),
            sizeof(TickState) + 2 * sizeof(control::LawState));
  EXPECT_LT(bytesOf(Hand({hold(kPoint, kWeak)}, Combine::Sum).state()),
            bytesOf(Hand({hold(kPoint, PD{})}, Combine::Sum).state()));
}

TEST(Step, GoldenThroughTheArm) {
  const double reach_m = test::thesisGeometry().upper_m + test::thesisGeometry().fore_m;
  int used = 0;
  for (const test::GoldenSet& set : test::constraintVectors().sets) {
    for (const test::GoldenCase& one : set.cases) {
      const Vec3 p_WT = kMetrePerMillimetre * one.P;
      const arm::PositionSolution angles = arm::solvePosition(test::thesisGeometry(), p_WT);
      if (!angles.reachable || (p_WT - test::thesisGeometry().p_WB).norm() > 0.999 * reach_m || one.degenerate)
        continue;
      const double radius_m = kMetrePerMillimetre * set.shape.radius,
                   off_m = kMetrePerMillimetre * offAxis(set.shape, one.P);
      if (off_m < 1e-9) continue;  // nearer to an axis than the arm's own rounding
      Hand hand({hold(makeShape(set.shape, kMetrePerMillimetre).value(), P{one.kp * kNewtonPerMetre})}, Combine::Sum);
      const TickReport& report = hand.feed(angles.q_rad);
      const double tip_m = (report.p_WT - p_WT).norm();
      ASSERT_LE(tip_m, 1e-14);  // there and back through six angles of 1 ulp, at the arm's length
      // Off by that much the nearest point is off by it once, and by R / off_axis of it around an axis.
      const double allowed_m = kMetrePerMillimetre * one.tol_Q + (1.0 + 2.0 * radius_m / off_m) * (tip_m + 1e-17);
      ASSERT_EQ(report.held[0].status, target::Status::Unique);
      ASSERT_LE((report.held[0].p_WP - kMetrePerMillimetre * one.Q).norm(), allowed_m)
          << set.shape.name << one.P.transpose();
      ASSERT_LE((report.f_T_W - one.force).norm(), 2.0 * one.tol_F + one.kp.x() * kNewtonPerMetre * (allowed_m + tip_m))
          << set.shape.name;
      ++used;
    }
  }
  EXPECT_GT(used, 250);
}

TEST(Step, WithEveryRampCompleteTheForceIsTheClampedOne) {
  Hand hand({hold(kPoint, P{Vec3::Constant(500.0)})}, Combine::Sum);
  const TickReport& report = hand.settle(kAway);
  EXPECT_EQ(report.level, 1.0);
  EXPECT_EQ(report.force.f_T_W(), safety::clampForce(report.f_T_W, 0.88));
  EXPECT_NEAR(report.force.f_T_W().norm(), 0.88, 1e-15);
  EXPECT_NEAR(report.cut_N, report.f_T_W.norm() - 0.88, 1e-13);
  EXPECT_EQ(report.fault.kind, FaultKind::None);
}

TEST(Step, ForcesAdd) {
  Hand one({hold(kPoint, kWeak)}, Combine::Sum), other({hold(kFloor, kWeak)}, Combine::Sum);
  Hand both({hold(kPoint, kWeak), hold(kFloor, kWeak)}, Combine::Sum);
  const TickReport& sum = both.at(kAway);
  EXPECT_EQ(sum.f_T_W, Vec3(one.at(kAway).f_T_W + other.at(kAway).f_T_W));
  EXPECT_EQ(sum.held.size(), 2U);
  EXPECT_TRUE(sum.held[0].acts && sum.held[1].acts);
  EXPECT_EQ(sum.held[0].f_T_W, one.report().f_T_W);
  EXPECT_NEAR(errorOf(sum), std::hypot(one.report().held[0].distance_m, other.report().held[0].distance_m), 1e-15);
}

TEST(Step, OnlyTheNearestActs) {
  Hand hand({hold(kPoint, kWeak), hold(kFloor, kWeak)}, Combine::Nearest);
  const TickReport& low = hand.at({0.1, 0.01, 0.03});  // 10 mm above the floor, 90 mm from the point
  EXPECT_FALSE(low.held[0].acts);
  EXPECT_TRUE(low.held[1].acts);
  EXPECT_EQ(low.held[0].f_T_W, kZero);
  EXPECT_EQ(low.f_T_W, low.held[1].f_T_W);
  EXPECT_NEAR(errorOf(low), 0.01, 1e-15);
  const TickReport& near = hand.at({0.015, 0.02, 0.03});
  EXPECT_TRUE(near.held[0].acts);
  EXPECT_FALSE(near.held[1].acts);
}

TEST(Step, TakesTheFirstOfEquallyNearConstraints) {
  Hand hand({hold(kPoint, kWeak), hold(kPoint, kWeak)}, Combine::Nearest);
  EXPECT_TRUE(hand.at(kAway).held[0].acts);
  EXPECT_FALSE(hand.report().held[1].acts);
}

TEST(Step, AFreeWallDoesNotCompete) {
  Hand hand({hold(kFloor, kWeak, Side::Outside), hold(kPoint, kWeak)}, Combine::Nearest);
  const TickReport& report = hand.at({0.1, 0.001, 0.03});  // 1 mm above the floor, free; 90 mm from the point
  EXPECT_EQ(report.held[0].status, target::Status::Free);
  EXPECT_FALSE(report.held[0].acts);
  EXPECT_TRUE(report.held[1].acts);
  EXPECT_GT(report.f_T_W.norm(), 0.5);
}

TEST(Step, AFreeWallHasNoPartInASum) {
  Hand hand({hold(kFloor, kWeak, Side::Outside)}, Combine::Sum);
  const TickReport& report = hand.at(kAway);
  EXPECT_EQ(report.held[0].status, target::Status::Free);
  EXPECT_FALSE(report.held[0].acts);
  EXPECT_EQ(report.held[0].p_WP, report.p_WT);
  EXPECT_EQ(report.f_T_W, kZero);
  EXPECT_EQ(errorOf(report), 0.0);
}

TEST(Step, ADegenerateTargetPullsNowhere) {  // the tip is made to be the centre, to the last bit
  Hand probe({hold(kPoint, kWeak)}, Combine::Sum);
  const Vec3 p_WT = probe.at(kAway).p_WT;
  Hand hand({hold(shape::makeSphere(p_WT, 0.04, {}).value(), kWeak)}, Combine::Sum);
  const TickReport& report = hand.at(kAway);
  EXPECT_EQ(report.held[0].status, target::Status::Degenerate);
  EXPECT_EQ(report.held[0].p_WP, report.p_WT);
  EXPECT_EQ(report.force.f_T_W(), kZero);
  EXPECT_EQ(report.fault.kind, FaultKind::None);
}

TEST(Step, AWallNeverPulls) {  // strong damping, a hand that leaves fast: PD alone would draw it back
  for (const control::Law& law :
       {control::Law(PD{Vec3::Constant(300.0), Vec3::Constant(30.0)}),
        control::Law(PID{Vec3::Constant(300.0), Vec3::Constant(30.0), Vec3::Constant(900.0), 0.4})}) {
    Hand hand({hold(kFloor, law, Side::Outside)}, Combine::Sum);
    bool cut = false;
    for (int tick = 0; tick < 3000; ++tick) {
      const double t_s = 1e-3 * tick;
      const TickReport& report = hand.at({0.02, 0.004 * std::sin(40.0 * t_s), 0.03});
      ASSERT_GE(report.f_T_W.y(), 0.0) << tick;
      if (report.p_WT.y() > 0.0) {
        ASSERT_EQ(report.f_T_W, kZero) << tick;
      }
      cut = cut || (report.p_WT.y() < -1e-4 && report.f_T_W == kZero);
    }
    EXPECT_TRUE(cut) << "the case did not come up";
  }
}

TEST(Step, AnAngleThatIsNotANumberIsZeroForceAndAFaultThatLasts) {
  for (std::size_t joint = 0; joint < 6; ++joint) {
    for (const double bad : {kNotANumber, kInfinity, -kInfinity}) {
      Hand hand({hold(kPoint, kWeak)}, Combine::Sum);
      const Vec3 p_WT = hand.settle(kAway).p_WT;
      ASSERT_GT(hand.report().force.f_T_W().norm(), 0.1);
      arm::JointAngles q_rad = hand.input.sample.q_rad;
      q_rad[joint] = bad;
      EXPECT_EQ(hand.feed(q_rad).force.f_T_W(), kZero) << joint;
      EXPECT_EQ(hand.report().fault.kind, FaultKind::NotFinite);
      EXPECT_EQ(hand.report().p_WT, p_WT) << "the last tip that was known";
      EXPECT_EQ(hand.report().held.size(), 0U);
      EXPECT_EQ(hand.report().f_T_W, kZero);
      for (int tick = 0; tick < 50; ++tick) {
        ASSERT_EQ(hand.at(kAway).force.f_T_W(), kZero);
        ASSERT_EQ(hand.report().fault.kind, FaultKind::NotFinite);
      }
      hand.input.restart = true;
      EXPECT_EQ(hand.at(kAway).fault.kind, FaultKind::None);
      EXPECT_GT(hand.settle(kAway).force.f_T_W().norm(), 0.1);
    }
  }
}

TEST(Step, AnglesWhoseSumOverflowsAreAFaultToo) {
  Hand hand({hold(kPoint, kWeak)}, Combine::Sum);
  hand.settle(kAway);
  EXPECT_EQ(hand.feed({0.0, 1.7e308, 1.7e308, 0, 0, 0}).force.f_T_W(), kZero);
  EXPECT_EQ(hand.report().fault.kind, FaultKind::NotFinite);
  EXPECT_TRUE(hand.report().p_WT.allFinite());
}

TEST(Step, ASampleThatIsNotNewerIsZeroForceAndCountsAsMissing) {
  Hand hand({hold(kPoint, kWeak)}, Combine::Sum);
  hand.settle(kAway);
  for (const double dt_s : {0.0, -1e-3}) {
    EXPECT_EQ(hand.at(kAway, dt_s).force.f_T_W(), kZero);
    EXPECT_EQ(hand.report().fault.kind, FaultKind::StaleSample);
  }
  EXPECT_EQ(hand.state().gate.missed, 2);
  EXPECT_EQ(hand.at(kAway, 5e-3).fault.kind, FaultKind::None);
  EXPECT_EQ(hand.state().gate.missed, 0);
}

TEST(Step, MissingSamplesAreZeroForceAndTooManyAFaultThatLasts) {
  Hand hand({hold(kPoint, kWeak)}, Combine::Sum);
  hand.settle(kAway);
  hand.input.has_sample = false;
  for (int tick = 1; tick <= 20; ++tick) {
    ASSERT_EQ(hand.at(kAway).force.f_T_W(), kZero);
    ASSERT_EQ(hand.report().fault.kind, FaultKind::NoSample);
    ASSERT_EQ(hand.state().gate.fault.kind, FaultKind::None) << tick;
  }
  hand.at(kAway);
  EXPECT_EQ(hand.state().gate.fault.kind, FaultKind::NoSample);
  EXPECT_EQ(hand.state().gate.fault.seen, 21.0);
  hand.input.has_sample = true;
  EXPECT_EQ(hand.at(kAway).force.f_T_W(), kZero);
  EXPECT_EQ(hand.report().fault.kind, FaultKind::NoSample);
}

TEST(Step, AfterRestartAClockThatBeganAnewIsTakenUp) {  // the arm was unplugged: its time starts from 0 again
  Hand hand({hold(kPoint, kWeak)}, Combine::Sum);
  hand.settle(kAway);
  hand.input.sample.time_ns = 0;
  for (int tick = 0; tick < 30; ++tick) EXPECT_EQ(hand.at(kAway).fault.kind, FaultKind::StaleSample);
  hand.input.restart = true;
  EXPECT_EQ(hand.at(kAway).fault.kind, FaultKind::None);
  EXPECT_GT(hand.settle(kAway).force.f_T_W().norm(), 0.1);
}

TEST(Step, NoClockIsTooStrange) {
  Hand hand({hold(kPoint, PD{Vec3::Constant(10.0), Vec3::Constant(1.0)})}, Combine::Sum);
  for (const std::int64_t time_ns : {std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max(),
                                     std::numeric_limits<std::int64_t>::min(), std::int64_t{0}}) {
    hand.input.sample.time_ns = time_ns;
    step(hand.program(), hand.input, hand.state(), const_cast<TickReport&>(hand.report()));
    EXPECT_TRUE(hand.report().force.f_T_W().allFinite());
    EXPECT_LE(hand.report().force.f_T_W().norm(), 0.88);
  }
}

TEST(Step, AfterALongPauseRateAndIntegralStartAsOnAFirstTick) {
  const PID law{Vec3::Constant(5.0), Vec3::Constant(1.0), Vec3::Constant(50.0), 0.4};
  Hand hand({hold(kPoint, law)}, Combine::Sum);
  hand.settle(kAway);
  for (int tick = 0; tick < 100; ++tick) hand.at(kAway + Vec3(1e-4 * tick, 0, 0));
  ASSERT_GT(hand.state().entries[0].law.velocity.rate_W.norm(), 0.05);
  ASSERT_GT(hand.state().entries[0].law.integral_T_W.norm(), 0.01);
  hand.at(kAway, 0.2);
  EXPECT_EQ(hand.state().entries[0].law.velocity.rate_W, kZero);
  EXPECT_EQ(hand.state().entries[0].law.integral_T_W, kZero);
  Hand fresh({hold(kPoint, law)}, Combine::Sum);
  EXPECT_EQ(hand.report().f_T_W, fresh.at(kAway).f_T_W);
}

TEST(Step, AfterAFaultTheIntegralIsEmpty) {
  const PID law{Vec3::Constant(10.0), kZero, Vec3::Constant(50.0), 0.4};
  Hand hand({hold(kPoint, law)}, Combine::Sum);
  hand.settle(kAway);
  for (int tick = 0; tick < 100; ++tick) hand.at(kAway);
  ASSERT_GT(hand.state().entries[0].law.integral_T_W.norm(), 0.01);
  arm::JointAngles bad = hand.input.sample.q_rad;
  bad[0] = kNotANumber;
  hand.feed(bad);
  hand.input.restart = true;
  hand.at(kAway);
  EXPECT_LE(hand.state().entries[0].law.integral_T_W.norm(), 1e-3 * 50.0 * 0.1);  // one tick's worth at most
}

TEST(Step, WithoutEngageNothingIsSentAndTheIntegralStaysEmpty) {
  Hand hand({hold(kPoint, PID{Vec3::Constant(10.0), kZero, Vec3::Constant(50.0), 0.4})}, Combine::Sum);
  hand.input.engage = false;
  EXPECT_EQ(hand.settle(kAway).force.f_T_W(), kZero);
  EXPECT_EQ(hand.state().entries[0].law.integral_T_W, kZero);
  EXPECT_GT(hand.report().f_T_W.norm(), 0.1) << "what would be asked is shown all the same";
}

TEST(Step, IdleEmptiesTheIntegralOfTheOnesThatDoNotActToo) {
  const PID law{Vec3::Constant(10.0), kZero, Vec3::Constant(50.0), 0.4};
  Hand hand({hold(kPoint, law), hold(kFloor, law)}, Combine::Nearest);
  hand.settle({0.012, 0.02, 0.03});
  for (int tick = 0; tick < 100; ++tick) hand.at({0.012, 0.02, 0.03});
  ASSERT_GT(hand.state().entries[0].law.integral_T_W.norm(), 1e-3);
  hand.input.engage = false;
  for (int tick = 0; tick < 200; ++tick) hand.at({0.1, 0.002, 0.03});  // the floor is nearer now
  EXPECT_EQ(hand.state().entries[0].law.integral_T_W, kZero);
}

TEST(Step, AConstraintThatLosesTheChoiceForgetsItsIntegral) {  // else it would come back as a jump, any time later
  const PID law{Vec3::Constant(10.0), kZero, Vec3::Constant(50.0), 0.4};
  Hand hand({hold(kPoint, law), hold(kFloor, law)}, Combine::Nearest);
  for (int tick = 0; tick < 800; ++tick) hand.at({0.018, 0.02, 0.03});
  ASSERT_GT(hand.state().entries[0].law.integral_T_W.norm(), 1e-3);
  hand.at({0.1, 0.002, 0.03});
  EXPECT_EQ(hand.state().entries[0].law.integral_T_W, kZero);
}

TEST(Step, WhileTheClampCutsTheIntegralDoesNotGrow) {
  Hand hand({hold(kPoint, PID{Vec3::Constant(500.0), kZero, Vec3::Constant(500.0), 0.4})}, Combine::Sum);
  hand.settle(kAway);
  for (int tick = 0; tick < 1000; ++tick) hand.at(kAway);
  EXPECT_EQ(hand.state().entries[0].law.integral_T_W, kZero);  // ramped, then cut, from the first tick on
}

TEST(Step, ADampedHandFeelsItsRate) {
  Hand hand({hold(kPoint, PD{kZero, Vec3::Constant(2.0)})}, Combine::Sum);
  for (int tick = 0; tick < 50; ++tick) hand.at(kAway + Vec3(1e-4 * tick, 0, 0));  // 0.1 m/s
  EXPECT_NEAR(hand.report().f_T_W.x(), -0.2, 1e-10);  // 50 ticks of the filter: (1.6 / 2.6)^49 = 5e-11 are missing
}

TEST(Step, ThroughTheSoftStartTheIntegralDoesNotGrow) {
  Hand hand({hold(kPoint, PID{Vec3::Constant(5.0), kZero, Vec3::Constant(50.0), 0.4})}, Combine::Sum);
  for (int tick = 0; tick < 295; ++tick) hand.at(kAway);
  EXPECT_EQ(hand.report().cut_N, 0.0);
  EXPECT_LE(hand.state().entries[0].law.integral_T_W.norm(),
            1e-3 * 50.0 * 0.1);  // the first tick does not know of the ramp
  hand.settle(kAway);
  EXPECT_GT(hand.state().entries[0].law.integral_T_W.norm(), 0.01);
}

TEST(Step, AReleaseIsSoftWithAnIntegralToo) {
  Hand hand({hold(kPoint, PID{Vec3::Constant(5.0), kZero, Vec3::Constant(50.0), 0.4})}, Combine::Sum);
  for (int tick = 0; tick < 800; ++tick) hand.at(kAway);
  const Vec3 before_N = hand.report().f_T_W;
  hand.input.engage = false;
  EXPECT_LE((hand.at(kAway).f_T_W - before_N).norm(), 1e-3 * 50.0 * 0.1);  // what a tick can add
  EXPECT_GT(hand.report().level, 0.9);
}

TEST(Step, WhileAFaultLastsTheIntegralIsEmpty) {
  Hand hand({hold(kPoint, PID{Vec3::Constant(5.0), kZero, Vec3::Constant(50.0), 0.4})}, Combine::Sum);
  for (int tick = 0; tick < 800; ++tick) hand.at(kAway);
  arm::JointAngles bad = hand.input.sample.q_rad;
  bad[0] = kNotANumber;
  hand.feed(bad);
  hand.at(kAway);
  EXPECT_EQ(hand.state().entries[0].law.integral_T_W, kZero);
}

TEST(Step, IdleEmptiesTheIntegralOfALostTargetToo) {
  Hand probe({hold(kPoint, kWeak)}, Combine::Sum);
  const shape::Shape sphere = shape::makeSphere(probe.at(kAway).p_WT, 0.04, {}).value();
  Hand hand({hold(sphere, PID{Vec3::Constant(5.0), kZero, Vec3::Constant(50.0), 0.4})}, Combine::Sum);
  hand.state().entries[0].law.integral_T_W = {0.1, 0, 0};
  hand.input.engage = false;
  EXPECT_EQ(hand.at(kAway).held[0].status, target::Status::Degenerate);
  EXPECT_EQ(hand.state().entries[0].law.integral_T_W, kZero);
}

TEST(Step, AtContactTheDampingIsThatOfTheHand) {  // 0.1 m/s into the floor, which was free a tick ago
  const PD law{Vec3::Constant(100.0), Vec3::Constant(2.0)};
  for (const Combine combine : {Combine::Sum, Combine::Nearest}) {
    Hand hand({hold(kFloor, law, Side::Outside), hold(kFloor, kWeak, Side::Inside)}, combine);
    hand.at({0.02, 0.5e-4, 0.03});
    const Vec3 f_T_W = hand.at({0.02, -0.5e-4, 0.03}).held[0].f_T_W;
    // e goes from 0, where it was free, to 0.05 mm: 0.05 m/s through the filter. The arm's rounding is 1e-16 m, over 1
    // ms.
    EXPECT_NEAR(f_T_W.y(), 100.0 * 0.5e-4 + 2.0 * 0.05 * 1e-3 / (1e-3 + control::kRateFilter_s), 1e-11);
  }
}

TEST(CarryOver, KeepsRampAndIntegralOverAChangeOfGains) {
  const auto program = [](double ki) {
    return makeProgram(test::thesisGeometry(),
                       {hold(kPoint, PID{Vec3::Constant(10.0), kZero, Vec3::Constant(ki), 0.4})}, Combine::Sum,
                       test::kTestLimits);
  };
  Hand hand(program(50.0));
  hand.settle(kAway);
  for (int tick = 0; tick < 100; ++tick) hand.at(kAway);
  const Vec3 before_N = hand.report().force.f_T_W();
  TickState next = makeState(program(100.0));
  carryOver(hand.state(), next);
  EXPECT_EQ(next.gate.level, 1.0);
  EXPECT_EQ(next.time_ns, hand.state().time_ns);
  EXPECT_EQ(next.p_WT, hand.state().p_WT);
  EXPECT_EQ(next.entries[0].law.integral_T_W, hand.state().entries[0].law.integral_T_W);
  TickReport report;
  hand.input.sample.time_ns += 1000000;
  step(program(100.0), hand.input, next, report);
  EXPECT_LE((report.force.f_T_W() - before_N).norm(), 1e-3 * 100.0 * 0.05);  // one tick's growth
  TickState arm_only = makeState(program(100.0));
  carryOver(hand.state(), arm_only, Carry::Arm);
  EXPECT_EQ(arm_only.entries[0].law.integral_T_W, kZero);
  EXPECT_EQ(arm_only.gate.level, 1.0);
}

TEST(CarryOver, OtherConstraintsGetNoForeignMemory) {
  const PID law{Vec3::Constant(10.0), kZero, Vec3::Constant(50.0), 0.4};
  Hand one({hold(kPoint, law)}, Combine::Sum);
  for (int tick = 0; tick < 800; ++tick) one.at(kAway);
  Hand two({hold(kFloor, law), hold(kPoint, law)}, Combine::Sum);
  carryOver(one.state(), two.state());
  EXPECT_EQ(two.state().entries[0].law.integral_T_W, kZero);
  EXPECT_EQ(two.state().gate.level, one.state().gate.level);
}

TEST(Report, ACopyHoldsWhatIsInUse) {
  Hand hand({hold(kPoint, kWeak), hold(kFloor, kWeak)}, Combine::Sum);
  const TickReport copy = hand.at(kAway);
  EXPECT_EQ(copy.held.size(), 2U);
  EXPECT_EQ(copy.held[1].p_WP, hand.report().held[1].p_WP);
  ConstraintReports list;
  list.resize(1000);
  EXPECT_EQ(list.size(), kMaxConstraints);
}

}  // namespace
}  // namespace underact::tick
