// The gate goes by the servo's time, whatever the clock of the samples says: how fast it lets go, pushes anew, heats.
#include <cmath>
#include <limits>

#include "tests/support/tick_hand.h"

namespace underact::tick {
namespace {

using test::Hand;
using test::hold;
using test::Random;
using test::Seed;

constexpr std::int64_t kMillisecond_ns = 1'000'000, kHour_ns = 3'600'000'000'000;
constexpr std::int64_t kFirst_ns = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t kLast_ns = std::numeric_limits<std::int64_t>::max();

/// A clock of samples that is none: the time of the one after `now_ns`, tick by tick.
struct OddClock {
  const char* name;
  std::int64_t (*next)(std::int64_t now_ns, std::int64_t tick);
};
const OddClock kOddClocks[] = {
    {"stands still", [](std::int64_t now_ns, std::int64_t) { return now_ns; }},
    {"a hundredth", [](std::int64_t now_ns, std::int64_t) { return now_ns + kMillisecond_ns / 100; }},
    {"half", [](std::int64_t now_ns, std::int64_t) { return now_ns + kMillisecond_ns / 2; }},
    {"true", [](std::int64_t now_ns, std::int64_t) { return now_ns + kMillisecond_ns; }},
    {"twice", [](std::int64_t now_ns, std::int64_t) { return now_ns + 2 * kMillisecond_ns; }},
    {"a hundred times", [](std::int64_t now_ns, std::int64_t) { return now_ns + 100 * kMillisecond_ns; }},
    {"just beyond 0.1 s", [](std::int64_t now_ns, std::int64_t) { return now_ns + 100 * kMillisecond_ns + 1; }},
    {"a thousand times", [](std::int64_t now_ns, std::int64_t) { return now_ns + 1000 * kMillisecond_ns; }},
    {"leaps on by 0.2 s",
     [](std::int64_t now_ns, std::int64_t tick) { return now_ns + (tick % 7 == 0 ? 200 : 1) * kMillisecond_ns; }},
    {"leaps back by 0.2 s",
     [](std::int64_t now_ns, std::int64_t tick) { return now_ns + (tick % 7 == 0 ? -200 : 1) * kMillisecond_ns; }},
    {"leaps on by an hour",
     [](std::int64_t now_ns, std::int64_t tick) { return now_ns + (tick % 7 == 0 ? kHour_ns : kMillisecond_ns); }},
    {"leaps back by an hour",
     [](std::int64_t now_ns, std::int64_t tick) { return now_ns + (tick % 7 == 0 ? -kHour_ns : kMillisecond_ns); }},
    {"between the ends of all numbers",
     [](std::int64_t, std::int64_t tick) { return tick % 2 == 0 ? kFirst_ns + tick : kLast_ns - tick; }},
};

/// Held to a point 10 cm away by 0.5 N, under the limits of a hand; ticked by a servo of 1 kHz.
Hand handHeld(const safety::Limits& limits = safety::limitsForHands(0.88, Vec3(0.155, 0.112, 0.131))) {
  Hand hand(makeProgram(test::thesisGeometry(),
                        {hold(shape::makePoint({0.0, 0.1, 0.03}, {}).value(), control::P{Vec3::Constant(5.0)})},
                        Combine::Sum, limits));
  hand.input.period_s = 1e-3;
  return hand;
}

const Vec3 kPlace{0.0, 0.0, 0.03};

/// The next tick by that clock, with the tip where it was.
const TickReport& tickBy(const OddClock& clock, std::int64_t tick, Hand& hand) {
  hand.input.sample.time_ns = clock.next(hand.input.sample.time_ns, tick);
  return hand.feed(arm::solvePosition(test::thesisGeometry(), kPlace).q_rad, 0.0);
}

double size_N(const TickReport& report) {
  return report.force.f_T_W().norm();
}

}  // namespace

TEST(ServoTime, AfterStopTheForceIsGoneWithinTheReleaseByAnyClock) {
  for (const OddClock& clock : kOddClocks) {
    Hand hand = handHeld();
    hand.settle(kPlace);
    ASSERT_NEAR(size_N(hand.report()), 0.5, 1e-9);
    hand.input.engage = false;
    for (int tick = 0; tick < 51; ++tick) tickBy(clock, tick, hand);
    for (int tick = 51; tick < 1000; ++tick) ASSERT_EQ(size_N(tickBy(clock, tick, hand)), 0.0) << clock.name;
  }
}

TEST(ServoTime, ASoftStartTakesItsTimeByAnyClockThatGoesOn) {
  for (const OddClock& clock : kOddClocks) {
    Hand hand = handHeld();
    hand.at(kPlace);
    double last_N = 0.0;
    for (int tick = 1; tick <= 400; ++tick) {
      const double now_N = size_N(tickBy(clock, tick, hand));
      ASSERT_LE(now_N, last_N + 0.5 / 300 + 1e-12) << clock.name << ' ' << tick;
      last_N = now_N;
      if (hand.report().fault.kind != FaultKind::None) break;  // a clock that goes back, or stands
      if (tick == 299) {
        EXPECT_LT(now_N, 0.5 - 1e-4) << clock.name;
      }
      if (tick == 301) {
        EXPECT_NEAR(now_N, 0.5, 1e-9) << clock.name;
      }
    }
  }
}

TEST(ServoTime, TheForceChangesByNoMoreThanTheSlewLimitOfAPeriod) {
  safety::Limits limits{0.88};
  limits.rise_s = 0.0;
  limits.max_slew_N_per_s = 20.0;  // 20 mN a tick
  for (const OddClock& clock : kOddClocks) {
    Hand hand = handHeld(limits);
    hand.settle(kPlace);
    Vec3 last_T_W = hand.report().force.f_T_W();
    for (int tick = 0; tick < 200; ++tick) {
      hand.input.sample.time_ns = clock.next(hand.input.sample.time_ns, tick);
      // To the other side of the point: the force turns round.
      const Vec3 f_T_W =
          hand.feed(arm::solvePosition(test::thesisGeometry(), Vec3(0.0, tick < 100 ? 0.0 : 0.02, 0.03)).q_rad, 0.0)
              .force.f_T_W();
      if (hand.report().fault.kind == FaultKind::None) {
        ASSERT_LE((f_T_W - last_T_W).norm(), 0.02 * (1.0 + 1e-12)) << clock.name << ' ' << tick;
      }
      last_T_W = f_T_W;
    }
  }
}

TEST(ServoTime, MotorsHeatByTheServosTime) {
  Hand well = handHeld();
  well.settle(kPlace);
  for (int tick = 0; tick < 5000; ++tick) well.at(kPlace);
  ASSERT_GT(well.report().heat.maxCoeff(), 0.01);
  for (const OddClock& clock : kOddClocks) {
    Hand hand = handHeld();
    hand.settle(kPlace);
    double pushes_s = 0.0;
    for (int tick = 0; tick < 5000; ++tick) pushes_s += size_N(tickBy(clock, tick, hand)) > 0.4 ? 1e-3 : 0.0;
    if (pushes_s < 5.0) continue;  // a fault: there is no force to heat them
    EXPECT_EQ(hand.report().heat, well.report().heat) << clock.name;
  }
}

TEST(ServoTime, WhatIsFrozenIsFoundByAnyClockThatGoesOn) {
  for (const OddClock& clock : kOddClocks) {
    safety::Limits limits{0.88};
    limits.frozen_s = 0.5;
    Hand hand = handHeld(limits);
    hand.settle(kPlace);
    for (int tick = 0; tick < 560; ++tick) tickBy(clock, tick, hand);
    EXPECT_EQ(size_N(hand.report()), 0.0) << clock.name;
  }
}

TEST(ServoTime, AClockThatLeapsHidesNoLeapOfTheTip) {
  for (const std::int64_t leap_ns : {4 * kMillisecond_ns, 90 * kMillisecond_ns, 200 * kMillisecond_ns, kHour_ns}) {
    Hand hand = handHeld();
    hand.settle(kPlace);
    hand.input.sample.time_ns += leap_ns;
    hand.feed(arm::solvePosition(test::thesisGeometry(), Vec3(0.1, 0.0, 0.03)).q_rad, 0.0);  // 0.1 m in 1 ms
    EXPECT_EQ(hand.report().fault.kind, FaultKind::TooFast) << leap_ns;
  }
}

TEST(ServoTime, AnArmWhoseSamplesWereMissingForAWhileMovedInAllOfIt) {
  Hand hand = handHeld();
  hand.settle(kPlace);
  hand.input.has_sample = false;
  for (int tick = 0; tick < 15; ++tick) hand.at(kPlace);
  hand.input.has_sample = true;
  hand.input.sample.time_ns += kMillisecond_ns;
  hand.feed(arm::solvePosition(test::thesisGeometry(), kPlace + Vec3(0.016, 0.0, 0.0)).q_rad,
            0.0);  // 1 m/s, 16 ms long
  EXPECT_EQ(hand.report().fault.kind, FaultKind::None);
}

TEST(ServoTime, DeadlinesThatPassedCountForReleaseAndHeatAndNotForSoftStart) {
  Hand hand = handHeld();
  hand.settle(kPlace);
  const Vec3 cold = hand.report().heat, warm = hand.at(kPlace).heat;
  hand.input.waited_s = 9e-3;
  hand.at(kPlace, 10e-3);
  EXPECT_NEAR((hand.report().heat - warm).norm(), 10.0 * (warm - cold).norm(), 1e-7);
  hand.input.engage = false;
  for (int tick = 0; tick < 5; ++tick) hand.at(kPlace, 10e-3);
  EXPECT_NEAR(size_N(hand.report()), 0.0, 1e-12) << "50 ms, in five ticks";
  hand.at(kPlace, 10e-3);
  EXPECT_EQ(size_N(hand.report()), 0.0);
  hand.input.engage = true;
  for (int tick = 0; tick < 30; ++tick) hand.at(kPlace, 10e-3);
  EXPECT_NEAR(hand.report().level, 30.0 / 300.0, 1e-12);
}

// Any sequence of sample times, of missing samples, starts and arms that begin anew.
TEST(ServoTime, WhateverComesInAStoppedServoHasLetGoAfterTheRelease) {
  for (int draw = 0; draw < test::sweep(300, 20'000); ++draw) {
    Random random(Seed{20260 + static_cast<std::uint64_t>(draw)});
    Hand hand = handHeld();
    const std::int64_t period_ns = std::int64_t{1'000'000'000} / (draw % 3 == 0 ? 100 : draw % 3 == 1 ? 1000 : 10'000);
    hand.input.period_s = 1e-9 * static_cast<double>(period_ns);
    const auto release = static_cast<int>(std::ceil(0.05 / hand.input.period_s)) + 1;
    int since_stop = 0;
    for (int tick = 0; tick < 4 * release + 200; ++tick) {
      if (random.below(static_cast<std::uint64_t>(2 * release)) == 0) {
        hand.input.engage = !hand.input.engage;
        hand.input.restart = hand.input.engage;
      }
      since_stop = hand.input.engage ? 0 : since_stop + 1;
      hand.input.has_sample = random.below(40) != 0;
      hand.input.restart |= random.below(500) == 0;
      hand.input.waited_s = random.below(30) == 0 ? hand.input.period_s * static_cast<double>(random.below(50)) : 0.0;
      const std::int64_t leaps_ns[] = {period_ns, period_ns,  period_ns, 2 * period_ns, period_ns / 2,
                                       0,         -period_ns, kHour_ns,  -kHour_ns,     200 * kMillisecond_ns};
      const std::uint64_t kind = random.below(12);
      auto time_ns = static_cast<std::uint64_t>(hand.input.sample.time_ns);
      time_ns = kind < 10 ? time_ns + static_cast<std::uint64_t>(leaps_ns[kind]) : random.bits();
      hand.input.sample.time_ns = static_cast<std::int64_t>(time_ns);
      hand.feed(arm::solvePosition(test::thesisGeometry(), kPlace).q_rad, 0.0);
      if (since_stop >= release) {
        ASSERT_EQ(size_N(hand.report()), 0.0) << "draw " << draw << ", tick " << tick;
      }
    }
  }
}

}  // namespace underact::tick
